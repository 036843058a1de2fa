#pragma once
// A pool of processes that turn items into answers, in the sandbox (see sandbox.hpp), in order. A worker that dies, or
// takes too long over an item, takes that item with it and is replaced; all others are answered as though nothing had
// happened. A worker that is killed from outside takes nothing with it: its item is tried again, three times in all.
// Items and answers are bytes; they travel in frames of many.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace blossom {

struct WorkerOptions {
  unsigned processes = 0;                // 0: one for each core; 1 is a process of its own, too
  double seconds_per_item = 20;          // of the processor; an item that takes longer is lost; 0: no limit
  std::size_t memory_bytes = 1u << 30;   // of address space beyond what the process began with; 0: no limit
  std::size_t answer_bytes = 64u << 20;  // an item whose answer is longer is lost
  std::size_t frame_bytes = 64u << 10;   // items travel in frames of at least so many bytes, but for the first and last
  std::size_t frame_items = 256;         // or so many items
  bool sandboxed = true;
};

// Why an item has no answer.
struct Lost {
  enum class Why : std::uint8_t {
    died,    // the worker did, of whatever the item made it do
    slow,    // it took too long
    failed,  // Work threw, of no memory for example
  } why;
  std::string text;  // "the grader died of signal 11 (SIGSEGV)"
};

// The cores that this process may use.
unsigned usable_cores();

class Workers {
 public:
  using Work = std::function<void(std::string_view item, std::string& answer)>;  // runs in a worker; answer is empty
  using Next = std::function<bool(std::string& item)>;                           // false: there are no more
  using Take =
      std::function<void(std::string_view item, std::string_view answer, const Lost*)>;  // in the order of items

  // Starts the processes. What Work needs it must have by then, for it can open nothing later: a library that reads its
  // settings when it is first used must have been used. No other thread may run. An item may be worked on again when
  // the worker died of another. Throws std::system_error where no process can be started.
  Workers(Work work, const WorkerOptions& options);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // May be called several times, one after the other. The memory held is bounded: `next` is not asked for more while
  // too many answers are outstanding. What next and take throw ends the run, and the workers with it.
  void run(const Next& next, const Take& take);

  // Why the workers are not (wholly) closed off; empty if they are.
  const std::string& open_because() const;

 private:
  class Pool;
  std::unique_ptr<Pool> pool_;
};

}  // namespace blossom
