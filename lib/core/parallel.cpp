// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel.h"

#include <tbb/flow_graph.h>

#include <deque>

namespace jam {

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
