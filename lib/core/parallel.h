// SPDX-License-Identifier: BSD-3-Clause
// The only door to oneTBB.
//
// Everything here gives the same bits for any number of threads: work is cut into blocks whose size
// never depends on the thread count, and whatever is summed is summed per block first and then over
// the blocks in order.
#pragma once

#include "core/types.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace jam {

/// Number of blocks of `block_size` that cover `count` items.
constexpr Count block_count(Count count, Count block_size) {
    return (count + block_size - 1) / block_size;
}

/// Runs `work()` with at most `threads` threads (0: as many as the machine has).
template <typename Work>
auto run_with_threads(int threads, Work&& work) {
    if (threads <= 0) return std::forward<Work>(work)();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute(std::forward<Work>(work));
}

/// Calls body(i) for every i in [0, count), each as a task of its own: for few, large pieces.
template <typename Body>
void for_each_task(Count count, Body&& body) {
    tbb::parallel_for(
        tbb::blocked_range<Count>(0, count, 1),
        [&](const tbb::blocked_range<Count>& range) {
            for (Count i = range.begin(); i != range.end(); ++i) body(i);
        },
        tbb::simple_partitioner{});
}

/// Calls body(block, begin, end) for every block of at most `block_size` items of [0, count).
template <typename Body>
void for_each_block(Count count, Count block_size, Body&& body) {
    tbb::parallel_for(tbb::blocked_range<Count>(0, block_count(count, block_size)),
                      [&](const tbb::blocked_range<Count>& blocks) {
                          for (Count b = blocks.begin(); b != blocks.end(); ++b)
                              body(b, b * block_size, std::min(count, (b + 1) * block_size));
                      });
}

/// Sum over blocks of body(begin, end) -> Value, added in the order of the blocks.
template <typename Value, typename Body>
Value sum_blocks(Count count, Count block_size, const Value& zero, Body&& body) {
    std::vector<Value> parts(static_cast<std::size_t>(block_count(count, block_size)), zero);
    for_each_block(count, block_size, [&](Count block, Count begin, Count end) {
        parts[static_cast<std::size_t>(block)] = body(begin, end);
    });
    Value sum = zero;
    for (const Value& part : parts) sum += part;
    return sum;
}

/// Largest of body(begin, end) -> double over blocks; zero for no items.
template <typename Body>
double max_blocks(Count count, Count block_size, Body&& body) {
    std::vector<double> parts(static_cast<std::size_t>(block_count(count, block_size)), 0.0);
    for_each_block(count, block_size, [&](Count block, Count begin, Count end) {
        parts[static_cast<std::size_t>(block)] = body(begin, end);
    });
    return parts.empty() ? 0.0 : *std::max_element(parts.begin(), parts.end());
}

/// values[i] becomes the sum of all before it; returns the sum of all.
template <typename Integer>
Integer exclusive_scan(std::vector<Integer>& values) {
    Integer sum = 0;
    for (Integer& value : values) sum += std::exchange(value, sum);
    return sum;
}

/// Sorts by a strict total order: no two items may compare equal, or the result would depend on
/// the thread count.
template <typename Range, typename Less>
void sort_total_order(Range& items, Less&& less) {
    tbb::parallel_sort(items.begin(), items.end(), std::forward<Less>(less));
}

/// Values of their own for each thread: scratch memory that outlives a task.
template <typename Scratch>
class PerThread {
  public:
    Scratch& local() { return values_.local(); }

  private:
    tbb::enumerable_thread_specific<Scratch> values_;
};

/// Stable counting sort of [0, keys.size()) by key. `begin` (size key_count + 1) receives where
/// each key's items begin, `order` (size keys.size()) the items. Stable, hence unique, hence the
/// same for any thread count.
void counting_sort(std::span<const Index> keys, Index key_count, std::vector<Index>& begin,
                   std::span<Index> order);

/// Tasks with prerequisites, run by a oneTBB flow graph as soon as what they need is done.
class TaskGraph {
  public:
    using Task = int;

    TaskGraph();
    ~TaskGraph();
    TaskGraph(const TaskGraph&) = delete;
    TaskGraph& operator=(const TaskGraph&) = delete;

    /// Adds a task that starts once all of `prerequisites` (tasks added before) are done.
    Task add(std::function<void()> work, const std::vector<Task>& prerequisites = {});

    /// Runs every task once; returns when all are done. An exception of a task is thrown here.
    void run();

  private:
    struct Graph;
    std::unique_ptr<Graph> graph_;
};

}  // namespace jam
