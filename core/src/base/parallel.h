#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/listener.h"

#if ABFLAT_THREADS
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#endif

namespace abflat {

/// Processors that threads can run on; 1 in a build without threads.
unsigned processors();

/// Fewer than asked for if the mesh is so small that starting a thread takes longer than it saves.
unsigned usefulThreads(int wanted, std::size_t faces);

class TaskGroup;

/// Threads that wait for tasks. A build without threads only has the caller's.
///
/// How work is split and in which order numbers are added up must never depend on the number of
/// threads, so that results do not either.
class ThreadPool {
 public:
  /// `threads` includes the caller's; 0: one per processor. There are fewer if the system refuses
  /// to start that many.
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  unsigned threads() const;

  /// From now on the owner's thread tells that work goes on, while it works and waits.
  void listen(const Listener& listener) { listener_ = listener; }
  /// To be called after `steps` small steps of work, whichever thread did them.
  void beat(std::size_t steps) const {
    if (isOwner()) listener_.beat(steps);
  }

 private:
  /// Whether this is the thread that made the pool.
  bool isOwner() const;

  Listener listener_;

#if ABFLAT_THREADS
  friend class TaskGroup;

  void work();
  /// Runs one task of the oldest group that has any, looking from `first` on: groups within a task
  /// are newer than the task's own group. `lock` is held before and after. False if there is no
  /// task.
  bool runOne(std::unique_lock<std::mutex>& lock, const TaskGroup* first);
  /// Waits until something may have changed.
  void pause(std::unique_lock<std::mutex>& lock);
  void announce();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<unsigned> changes_{0};
  std::vector<TaskGroup*> groups_;  ///< the open ones, oldest first
  bool isEnding_ = false;
  const std::thread::id owner_ = std::this_thread::get_id();
  std::vector<std::thread> threads_;
#endif
};

/// Tasks that may run at the same time, and may add further tasks. Groups of one thread nest.
/// Within a group the last task added runs first.
class TaskGroup {
 public:
  using Task = std::function<void()>;

  explicit TaskGroup(ThreadPool* pool);  ///< null: wait() runs all
  ~TaskGroup();
  TaskGroup(const TaskGroup&) = delete;
  TaskGroup& operator=(const TaskGroup&) = delete;

  /// Called by the group's owner before wait(), or by one of its tasks.
  void add(Task task);

  /// Runs tasks until all are done. If one of them runs out of memory, tasks that have not begun
  /// are dropped, and the error appears here as it would in a single thread.
  void wait();

 private:
  std::vector<Task> ready_;
  void runAll();
#if ABFLAT_THREADS
  friend class ThreadPool;

  void finish();

  ThreadPool* pool_;  ///< null: one thread
  std::size_t unfinished_ = 0;
  std::exception_ptr error_;
#endif
};

/// Calls work(i) for each i below `count`, in any order and concurrently.
void parallelFor(ThreadPool* pool, std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls work(begin, end) for ranges of `grain` that together are [0, count).
void parallelRanges(ThreadPool* pool, std::size_t count, std::size_t grain,
                    const std::function<void(std::size_t, std::size_t)>& work);

#if ABFLAT_THREADS
using SharedMutex = std::mutex;
#else
struct SharedMutex {
  void lock() {}
  void unlock() {}
};
#endif

struct SharedLock {
  explicit SharedLock(SharedMutex& mutex) : mutex_(mutex) { mutex_.lock(); }
  ~SharedLock() { mutex_.unlock(); }
  SharedLock(const SharedLock&) = delete;
  SharedLock& operator=(const SharedLock&) = delete;

 private:
  SharedMutex& mutex_;
};

/// Work space that a task leaves to the next one; there are as many as tasks run concurrently.
template <typename T>
class Spares {
 public:
  /// Null if there is none.
  std::unique_ptr<T> take() {
    const SharedLock lock(mutex_);
    if (spares_.empty()) return nullptr;
    std::unique_ptr<T> spare = std::move(spares_.back());
    spares_.pop_back();
    return spare;
  }
  void give(std::unique_ptr<T> spare) {
    const SharedLock lock(mutex_);
    spares_.push_back(std::move(spare));
  }

 private:
  SharedMutex mutex_;
  std::vector<std::unique_ptr<T>> spares_;
};

inline bool isParallel(const ThreadPool* pool) { return pool && pool->threads() > 1; }

inline void beat(const ThreadPool* pool, std::size_t steps) {
  if (pool) pool->beat(steps);
}

}  // namespace abflat
