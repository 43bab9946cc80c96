#include "base/parallel.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <system_error>
#include <utility>

namespace abflat {
namespace {

/// Small steps of a Listener that every task counts for, whatever it does.
constexpr std::size_t kStepsOfTask = 1 << 7;
/// Elements of a range that count as one step.
constexpr std::size_t kPerStep = 8;

}  // namespace

#if ABFLAT_THREADS
namespace {

/// How often an idle thread looks again before it sleeps: within a dense front, what it waits for
/// takes less time than waking up.
constexpr int kLooks = 100;
/// How long the owner waits for others before it reports again.
constexpr std::chrono::milliseconds kSilence{50};

}  // namespace

unsigned processors() {
  const unsigned found = std::max(1u, std::thread::hardware_concurrency());
#ifdef ABFLAT_MOST_THREADS
  return std::min(found, unsigned{ABFLAT_MOST_THREADS});
#else
  return found;
#endif
}

ThreadPool::ThreadPool(unsigned threads) {
#ifdef ABFLAT_MOST_THREADS
  threads = std::min(threads, processors());  // there are no workers for more
#endif
  const unsigned others = (threads == 0 ? processors() : threads) - 1;
  threads_.reserve(others);
  for (unsigned i = 0; i < others; ++i) {
#ifdef __cpp_exceptions
    try {
      threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      break;
    } catch (const std::bad_alloc&) {
      break;
    }
#else
    threads_.emplace_back([this] { work(); });
#endif
  }
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    isEnding_ = true;
    announce();
  }
  for (std::thread& thread : threads_) thread.join();
}

unsigned ThreadPool::threads() const { return static_cast<unsigned>(threads_.size()) + 1; }

bool ThreadPool::isOwner() const { return std::this_thread::get_id() == owner_; }

void ThreadPool::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!isEnding_)
    if (!runOne(lock, nullptr)) pause(lock);
}

bool ThreadPool::runOne(std::unique_lock<std::mutex>& lock, const TaskGroup* first) {
  auto group = first ? std::find(groups_.begin(), groups_.end(), first) : groups_.begin();
  while (group != groups_.end() && (*group)->ready_.empty()) ++group;
  if (group == groups_.end()) return false;
  TaskGroup& g = **group;
  {
    const TaskGroup::Task task = std::move(g.ready_.back());
    g.ready_.pop_back();
    lock.unlock();
#ifdef __cpp_exceptions
    std::exception_ptr error;
    try {
      task();
    } catch (...) {  // passed on to the group's owner, whichever thread that is
      error = std::current_exception();
    }
    lock.lock();
    if (error) {
      g.unfinished_ -= g.ready_.size();
      g.ready_.clear();
      g.error_ = error;
    }
#else
    task();
    lock.lock();
#endif
  }
  if (--g.unfinished_ == 0) announce();
  return true;
}

void ThreadPool::pause(std::unique_lock<std::mutex>& lock) {
  const unsigned seen = changes_.load();
  lock.unlock();
  for (int i = 0; i < kLooks && changes_.load() == seen; ++i) std::this_thread::yield();
  lock.lock();
  const auto isChanged = [&] { return changes_.load() != seen; };
  if (!isOwner()) return changed_.wait(lock, isChanged);
  while (!changed_.wait_for(lock, kSilence, isChanged)) {
    lock.unlock();
    listener_.tell();
    lock.lock();
  }
}

void ThreadPool::announce() {
  ++changes_;
  changed_.notify_all();
}

TaskGroup::TaskGroup(ThreadPool* pool) : pool_(isParallel(pool) ? pool : nullptr) {
  if (!pool_) return;
  const std::lock_guard<std::mutex> lock(pool_->mutex_);
  pool_->groups_.push_back(this);
}

TaskGroup::~TaskGroup() {
  if (!pool_) return;
  finish();
  const std::lock_guard<std::mutex> lock(pool_->mutex_);
  pool_->groups_.erase(std::find(pool_->groups_.begin(), pool_->groups_.end(), this));
}

void TaskGroup::add(Task task) {
  if (!pool_) {
    ready_.push_back(std::move(task));
    return;
  }
  const std::lock_guard<std::mutex> lock(pool_->mutex_);
  if (error_) return;
  ready_.push_back(std::move(task));
  ++unfinished_;
  pool_->announce();
}

void TaskGroup::finish() {
  std::unique_lock<std::mutex> lock(pool_->mutex_);
  while (unfinished_ > 0)
    if (!pool_->runOne(lock, this)) pool_->pause(lock);
}

void TaskGroup::wait() {
  if (!pool_) return runAll();
  finish();
#ifdef __cpp_exceptions
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
#endif
}

#else

unsigned processors() { return 1; }

ThreadPool::ThreadPool(unsigned) {}
ThreadPool::~ThreadPool() = default;
unsigned ThreadPool::threads() const { return 1; }
bool ThreadPool::isOwner() const { return true; }

TaskGroup::TaskGroup(ThreadPool*) {}
TaskGroup::~TaskGroup() = default;
void TaskGroup::add(Task task) { ready_.push_back(std::move(task)); }

void TaskGroup::wait() { runAll(); }

#endif

void TaskGroup::runAll() {
  while (!ready_.empty()) {
    const Task task = std::move(ready_.back());
    ready_.pop_back();
    task();
  }
}

unsigned usefulThreads(int wanted, std::size_t faces) {
  constexpr std::size_t kFacesPerThread = 2000;
  const std::size_t most = wanted > 0 ? static_cast<std::size_t>(wanted) : processors();
  return static_cast<unsigned>(std::clamp<std::size_t>(faces / kFacesPerThread, 1, most));
}

void parallelFor(ThreadPool* pool, std::size_t count,
                 const std::function<void(std::size_t)>& work) {
#if ABFLAT_THREADS
  if (isParallel(pool) && count > 1) {
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
        pool->beat(kStepsOfTask);
      }
    };
    TaskGroup group(pool);
    const std::size_t threads = std::min<std::size_t>(count, pool->threads());
    for (std::size_t i = 0; i < threads; ++i) group.add(run);
    group.wait();
    return;
  }
#endif
  for (std::size_t i = 0; i < count; ++i) {
    work(i);
    beat(pool, kStepsOfTask);
  }
}

void parallelRanges(ThreadPool* pool, std::size_t count, std::size_t grain,
                    const std::function<void(std::size_t, std::size_t)>& work) {
  if (!pool || count <= grain) {
    if (count > 0) work(0, count);
    beat(pool, count / kPerStep);
    return;
  }
  parallelFor(pool, (count + grain - 1) / grain, [&](std::size_t i) {
    work(i * grain, std::min(count, (i + 1) * grain));
    pool->beat(grain / kPerStep);
  });
}

}  // namespace abflat
