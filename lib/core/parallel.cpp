// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel.h"

#include <tbb/flow_graph.h>

#include <deque>

namespace jam {

void counting_sort(std::span<const Index> keys, Index key_count, std::vector<Index>& begin,
                   std::span<Index> order) {
    constexpr Count least_chunk = 1 << 15;
    constexpr Count most_chunks = 16;
    const auto count = static_cast<Count>(keys.size());
    const Count chunk = std::max(least_chunk, block_count(count, most_chunks));
    const Count chunks = block_count(count, chunk);
    const auto width = static_cast<std::size_t>(key_count);

    std::vector<Index> place(static_cast<std::size_t>(chunks) * width, 0);
    const auto places_of = [&](Count c) {
        return place.data() + static_cast<std::size_t>(c) * width;
    };
    for_each_block(count, chunk, [&](Count c, Count first, Count last) {
        Index* histogram = places_of(c);
        for (Count i = first; i < last; ++i) ++histogram[keys[static_cast<std::size_t>(i)]];
    });
    begin.resize(width + 1);
    Index before = 0;
    for (std::size_t key = 0; key < width; ++key) {
        begin[key] = before;
        for (Count c = 0; c < chunks; ++c) before += std::exchange(places_of(c)[key], before);
    }
    begin[width] = before;
    for_each_block(count, chunk, [&](Count c, Count first, Count last) {
        Index* next = places_of(c);
        for (Count i = first; i < last; ++i) {
            const Index key = keys[static_cast<std::size_t>(i)];
            order[static_cast<std::size_t>(next[key]++)] = static_cast<Index>(i);
        }
    });
}

using FlowNode = tbb::flow::continue_node<tbb::flow::continue_msg>;

struct TaskGraph::Graph {
    tbb::flow::graph flow;
    tbb::flow::broadcast_node<tbb::flow::continue_msg> start{flow};
    std::deque<FlowNode> nodes;
};

TaskGraph::TaskGraph() : graph_(std::make_unique<Graph>()) {}
TaskGraph::~TaskGraph() = default;

TaskGraph::Task TaskGraph::add(std::function<void()> work, const std::vector<Task>& prerequisites) {
    FlowNode& node = graph_->nodes.emplace_back(
        graph_->flow, [work = std::move(work)](const tbb::flow::continue_msg&) { work(); });
    if (prerequisites.empty()) tbb::flow::make_edge(graph_->start, node);
    for (const Task task : prerequisites)
        tbb::flow::make_edge(graph_->nodes[static_cast<std::size_t>(task)], node);
    return static_cast<Task>(graph_->nodes.size()) - 1;
}

void TaskGraph::run() {
    graph_->start.try_put(tbb::flow::continue_msg());
    graph_->flow.wait_for_all();
}

}  // namespace jam
