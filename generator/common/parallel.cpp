#include "common/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <thread>

#include "common/provenance.hpp"

namespace treedyn {

namespace {

/// Threads that may still be started.
std::atomic<int>& free_threads() {
  static std::atomic<int> count{std::max(1, static_cast<int>(std::thread::hardware_concurrency())) -
                                1};
  return count;
}

/// One thread, if there is one left.
class Taken {
 public:
  Taken() : has_(free_threads().fetch_sub(1) > 0) {
    if (!has_) {
      ++free_threads();
    }
  }
  ~Taken() {
    if (has_) {
      ++free_threads();
    }
  }
  Taken(Taken&& other) noexcept : has_(std::exchange(other.has_, false)) {}
  Taken& operator=(Taken&&) = delete;

  explicit operator bool() const { return has_; }

 private:
  bool has_;
};

struct Outcome {
  std::shared_ptr<Sources> sources;
  std::exception_ptr error;
};

void run(const std::function<void()>& task, Outcome& outcome) {
  const std::shared_ptr<Sources> own = exchange_sources(outcome.sources);
  try {
    task();
  } catch (...) {
    outcome.error = std::current_exception();
  }
  exchange_sources(own);
}

/// Calls `work` here and in as many threads more as there are and `most` allows.
void share(const std::function<void()>& work, std::size_t most) {
  std::vector<std::jthread> others;
  while (others.size() < most) {
    Taken thread;
    if (!thread) {
      break;
    }
    others.emplace_back([&work, taken = std::move(thread)] { work(); });
  }
  work();
}

}  // namespace

void set_threads(int count) { free_threads() = count - 1; }

void run_all(const std::vector<std::function<void()>>& tasks) {
  std::vector<Outcome> outcomes;
  while (outcomes.size() < tasks.size()) {
    outcomes.push_back({copy_of_sources(), nullptr});
  }
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < tasks.size(); k = next++) {
      run(tasks[k], outcomes[k]);
    }
  };
  share(work, tasks.empty() ? 0 : tasks.size() - 1);
  for (const Outcome& outcome : outcomes) {
    if (outcome.error) {
      std::rethrow_exception(outcome.error);
    }
  }
  for (const Outcome& outcome : outcomes) {
    learn_sources(*outcome.sources);
  }
}

}  // namespace treedyn
