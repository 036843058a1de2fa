#include "grader/batch/workers.hpp"

#include <errno.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include "grader/batch/worker_process.hpp"

namespace blossom {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::size_t block = 256u << 10;     // bytes that are received at once
constexpr std::size_t most_held = 32u << 20;  // bytes of answers that wait for an earlier one
constexpr std::size_t frames_of_worker = 2;   // one that it works on, and one so that it need not wait
constexpr std::size_t first_frame_items = 4;  // a small class is to be spread, too
constexpr double idle_factor = 10;            // so many times its time an item may take that does not compute
constexpr int deaths_without_guilt = 3;       // so often a worker may die between items, or be killed at one

struct Entry {
  enum class State : std::uint8_t { asked, answered, lost } state = State::asked;
  std::size_t item = 0;  // where it begins in the frame's items
  Word item_length = 0;
  Word answer_length = 0;
  std::size_t answer = 0;  // where it begins in the frame's answers
};

struct Frame {
  std::string items;  // as they are sent, with their head
  std::vector<Entry> entries;
  std::string answers;
  std::vector<std::pair<std::size_t, Lost>> lost;  // few
  std::size_t received = 0;                        // entries before this one have an answer, or are lost
  std::size_t delivered = 0;

  void clear() {
    items.assign(sizeof(FrameHead), '\0');
    entries.clear();
    answers.clear();
    lost.clear();
    received = delivered = 0;
  }
  void add(std::string_view item) {
    if (item.size() > (1u << 30)) throw std::length_error("an item of more than 1 GiB");
    append_raw(items, static_cast<Word>(item.size()));
    entries.push_back({Entry::State::asked, items.size(), static_cast<Word>(item.size()), 0, 0});
    items += item;
  }
  void close() {
    const FrameHead head{static_cast<Word>(entries.size()), static_cast<Word>(items.size() - sizeof(FrameHead))};
    std::memcpy(items.data(), &head, sizeof head);
  }
  std::string_view item(const Entry& entry) const {
    return std::string_view(items).substr(entry.item, entry.item_length);
  }
  void skip_received() {
    while (received < entries.size() && entries[received].state != Entry::State::asked) ++received;
  }
  bool is_answered() const { return received == entries.size(); }

  // The entries that are still asked, as a frame of their own.
  std::string asked_again() const {
    Frame again;
    again.clear();
    for (const Entry& entry : entries)
      if (entry.state == Entry::State::asked) again.add(item(entry));
    again.close();
    return std::move(again.items);
  }
};

// A place for a worker, with the frames it has been given and not answered wholly.
struct Slot {
  std::unique_ptr<WorkerProcess> process;
  std::deque<Frame*> frames;
  std::deque<std::string> again;  // what is to be sent instead of the frames' own items, after a replacement
  std::size_t unsent = 0;         // of the frames, the last so many are not sent wholly
  std::size_t sent_bytes = 0;     // and of the first of those, so many bytes are
  std::string received;           // what is not yet a whole answer
  std::uint64_t answers = 0;      // of this process
  std::uint64_t seen = 0;         // its progress, when last looked at
  double waited = 0;              // so long it has been there
  double had = 0;                 // and so much of the processor's time it had had before
  int deaths = 0;                 // that no item was guilty of, without an answer since

  std::string_view outgoing() const {
    if (unsent == 0) return {};
    const std::size_t at = frames.size() - unsent;
    const std::string& bytes = at < again.size() ? again[at] : frames[at]->items;
    return std::string_view(bytes).substr(sent_bytes);
  }
};

std::string seconds_text(double seconds) {
  const double rounded = std::round(seconds * 10) / 10;
  std::string text = std::to_string(rounded);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.' || text.back() == ',') text.pop_back();
  return text;
}

}  // namespace

unsigned usable_cores() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0) return static_cast<unsigned>(CPU_COUNT(&set));
  return std::max(1u, std::thread::hardware_concurrency());
}

class Workers::Pool {
 public:
  Pool(Work work, const WorkerOptions& options) : work_(std::move(work)), options_(options), block_(block, '\0') {
    slots_.resize(options_.processes != 0 ? options_.processes : usable_cores());
    for (Slot& slot : slots_) slot.process = std::make_unique<WorkerProcess>(work_, options_, open_because_);
    most_frames_ = 4 * slots_.size() + 4;
    tick_ = options_.seconds_per_item > 0 ? std::clamp(options_.seconds_per_item / 8, 0.01, 0.5) : 0.5;
  }

  const std::string& open_because() const { return open_because_; }

  void run(const Next& next, const Take& take) {
    if (ended_) throw std::logic_error("the workers have ended");
    ended_ = true;  // unless all goes well
    bool more = true;
    frame_items_ = first_frame_items;
    for (;;) {
      while (more && wants_more()) more = add_frame(next);
      if (frames_.empty()) break;
      exchange();
      watch();
      deliver(take);
    }
    ended_ = false;
  }

 private:
  // The worker that has least to do, if any has little enough.
  Slot* idle() {
    Slot* slot = &*std::ranges::min_element(slots_, {}, [](const Slot& s) { return s.frames.size(); });
    return slot->frames.size() < frames_of_worker ? slot : nullptr;
  }
  bool wants_more() { return frames_.size() < most_frames_ && idle() != nullptr; }

  bool add_frame(const Next& next) {
    std::unique_ptr<Frame> frame;
    if (spare_.empty()) {
      frame = std::make_unique<Frame>();
    } else {
      frame = std::move(spare_.back());
      spare_.pop_back();
    }
    frame->clear();
    bool more = true;
    const std::size_t most = std::max<std::size_t>(1, std::min(frame_items_, options_.frame_items));
    while (frame->entries.size() < most && frame->items.size() < options_.frame_bytes && (more = next(item_)))
      frame->add(item_);
    if (frame->entries.empty()) return false;
    frame->close();
    if (++frames_made_ % slots_.size() == 0 && frame_items_ < options_.frame_items) frame_items_ *= 2;
    Slot& slot = *idle();
    slot.frames.push_back(frame.get());
    ++slot.unsent;
    frames_.push_back(std::move(frame));
    send(slot);
    return more;
  }

  // Where too much waits for an earlier answer, only the worker that owes that one is listened to.
  bool listens_to(const Slot& slot) const {
    return held_ < most_held || (!slot.frames.empty() && slot.frames.front() == frames_.front().get());
  }

  // Sends as much as goes, and receives what there is; waits if there is nothing to do.
  void exchange() {
    polled_.clear();
    for (const Slot& slot : slots_) {
      const int events = (listens_to(slot) ? POLLIN : 0) | (slot.unsent > 0 ? POLLOUT : 0);
      polled_.push_back({slot.process->socket(), static_cast<short>(events), 0});
    }
    if (poll(polled_.data(), polled_.size(), static_cast<int>(tick_ * 1000)) < 0 && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "waiting for workers");
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      const short events = polled_[i].revents;
      if ((events & (POLLIN | POLLERR | POLLHUP)) != 0) {
        const Received received = receive(slots_[i], 4 * block);
        if (received == Received::nonsense) {
          replace(slots_[i], Lost{Lost::Why::died, "the grader answered what was not asked"});
          continue;
        }
        if (received == Received::end) {
          replace(slots_[i]);
          continue;
        }
      }
      if ((events & POLLOUT) != 0) send(slots_[i]);
    }
  }

  // A worker that is gone is noticed by receive.
  void send(Slot& slot) {
    while (slot.unsent > 0) {
      const std::string_view bytes = slot.outgoing();
      const ssize_t put = ::send(slot.process->socket(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      if (put < 0) return;
      slot.sent_bytes += static_cast<std::size_t>(put);
      if (static_cast<std::size_t>(put) < bytes.size()) return;
      --slot.unsent;
      slot.sent_bytes = 0;
    }
  }

  enum class Received : std::uint8_t { some, end, nonsense };
  Received receive(Slot& slot, std::size_t most) {
    for (std::size_t total = 0; total < most;) {
      const ssize_t got = recv(slot.process->socket(), block_.data(), block_.size(), MSG_DONTWAIT);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return Received::some;
      if (got <= 0) return Received::end;
      total += static_cast<std::size_t>(got);
      std::string_view bytes(block_.data(), static_cast<std::size_t>(got));
      if (!slot.received.empty()) {  // the rest of an answer that came in part
        slot.received += bytes;
        bytes = slot.received;
      }
      const std::size_t all = bytes.size();
      if (!take_answers(slot, bytes)) return Received::nonsense;
      if (slot.received.empty()) {
        slot.received = bytes;
      } else {
        slot.received.erase(0, all - bytes.size());
      }
    }
    return Received::some;
  }

  // Takes whole answers off the bytes. False where they cannot be meant.
  bool take_answers(Slot& slot, std::string_view& bytes) {
    while (bytes.size() >= sizeof(AnswerHead)) {
      const auto head = read_raw<AnswerHead>(bytes.data());
      const std::size_t most = head.kind == 0 ? options_.answer_bytes : most_reason;
      if (slot.frames.empty() || head.kind > 1 || head.length > most) return false;
      if (bytes.size() - sizeof head < head.length) return true;
      const std::string_view text = bytes.substr(sizeof head, head.length);
      bytes.remove_prefix(sizeof head + head.length);
      Frame& frame = *slot.frames.front();
      Entry& entry = frame.entries[frame.received];
      if (head.kind == 0) {
        entry.state = Entry::State::answered;
        entry.answer = frame.answers.size();
        entry.answer_length = head.length;
        frame.answers += text;
        held_ += text.size();
      } else {
        lose(frame, frame.received, {Lost::Why::failed, std::string(text)});
      }
      ++slot.answers;
      slot.deaths = 0;
      frame.skip_received();
      drop_answered(slot);
    }
    return true;
  }

  static void lose(Frame& frame, std::size_t entry, Lost why) {
    frame.entries[entry].state = Entry::State::lost;
    frame.lost.emplace_back(entry, std::move(why));
  }

  static void drop_answered(Slot& slot) {
    while (!slot.frames.empty() && slot.frames.front()->is_answered()) {
      slot.frames.pop_front();
      if (!slot.again.empty()) slot.again.pop_front();
      if (slot.unsent > slot.frames.size()) {  // an answer to what was not asked
        slot.unsent = slot.frames.size();
        slot.sent_bytes = 0;
      }
    }
  }

  // The worker has ended, or has to: whatever it was at is lost, and a new one gets the rest.
  void replace(Slot& slot, std::optional<Lost> because = std::nullopt) {
    const std::string ended = slot.process->end();
    if (because && because->why == Lost::Why::slow) receive(slot, SIZE_MAX);
    const std::uint64_t progress = slot.process->progress();
    Lost why = because ? std::move(*because) : Lost{Lost::Why::died, "the grader " + ended};
    // A worker that is not at an item, or that somebody killed (an administrator, the system for want of memory), has
    // died of something else, unless it does so again and again.
    const bool guilty = progress % 2 != 0 && (why.why == Lost::Why::slow || !slot.process->was_killed());
    if (!slot.frames.empty() && (guilty || ++slot.deaths >= deaths_without_guilt)) {
      lose_at(slot, progress / 2 >= slot.answers ? progress / 2 - slot.answers : 0, std::move(why));
      slot.deaths = 0;
    }
    slot.received.clear();
    slot.answers = slot.seen = 0;
    slot.waited = slot.had = 0;
    slot.sent_bytes = 0;
    slot.again.clear();
    for (const Frame* frame : slot.frames) slot.again.push_back(frame->asked_again());
    slot.unsent = slot.frames.size();
    slot.process.reset();
    slot.process = std::make_unique<WorkerProcess>(work_, options_, open_because_);
    send(slot);
  }

  // Loses the nth of the slot's items without an answer. A worker may say that it is anywhere: where there is no such,
  // it is the first.
  static void lose_at(Slot& slot, std::uint64_t nth, Lost why) {
    std::pair<Frame*, std::size_t> guilty{slot.frames.front(), slot.frames.front()->received};
    for (Frame* frame : slot.frames)
      for (std::size_t i = frame->received; i < frame->entries.size(); ++i)
        if (frame->entries[i].state == Entry::State::asked && nth-- == 0) guilty = {frame, i};
    lose(*guilty.first, guilty.second, std::move(why));
    for (Frame* frame : slot.frames) frame->skip_received();
    drop_answered(slot);
    // A later frame whose only item is lost has nothing to be sent.
    std::erase_if(slot.frames, [](const Frame* frame) { return frame->is_answered(); });
  }

  // Ends the workers that have been too long over an item: by the time of the processor they had, so that a machine
  // that does much else gives the same answers; by the clock they may wait far longer. Of the clock only the time in
  // which this process ran counts, for both may have been stopped, and only a tick each time, for whoever takes our
  // answers may make us wait.
  void watch() {
    const auto now = Clock::now();
    const double passed = Seconds(now - watched_).count();
    const double most = options_.seconds_per_item;
    if (most <= 0 || passed < tick_ / 2) return;
    watched_ = now;
    for (Slot& slot : slots_) {
      const std::uint64_t progress = slot.process->progress();
      const bool has_work = !slot.frames.empty() && slot.unsent == 0 && listens_to(slot);
      if (progress != slot.seen || (progress % 2 == 0 && !has_work)) {
        slot.seen = progress;
        slot.waited = 0;
        slot.had = slot.process->processor_seconds();
        continue;
      }
      slot.waited += std::min(passed, 2 * tick_);
      if (slot.process->processor_seconds() - slot.had > most || slot.waited > idle_factor * most)
        replace(slot, Lost{Lost::Why::slow, "the grader took more than " + seconds_text(most) + " seconds over it"});
    }
  }

  void deliver(const Take& take) {
    while (!frames_.empty()) {
      Frame& frame = *frames_.front();
      for (; frame.delivered < frame.received; ++frame.delivered) {
        const Entry& entry = frame.entries[frame.delivered];
        if (entry.state == Entry::State::lost) {
          const auto lost = std::ranges::find(frame.lost, frame.delivered, &std::pair<std::size_t, Lost>::first);
          take(frame.item(entry), {}, &lost->second);
        } else {
          held_ -= entry.answer_length;
          take(frame.item(entry), std::string_view(frame.answers).substr(entry.answer, entry.answer_length), nullptr);
        }
      }
      frame.answers.clear();
      if (!frame.is_answered()) return;
      if (frame.items.capacity() + frame.answers.capacity() < 8 * block) spare_.push_back(std::move(frames_.front()));
      frames_.pop_front();
    }
  }

  Work work_;
  WorkerOptions options_;
  std::string block_;
  std::string open_because_;
  std::vector<Slot> slots_;
  std::deque<std::unique_ptr<Frame>> frames_;  // in the order of items
  std::vector<std::unique_ptr<Frame>> spare_;
  std::vector<pollfd> polled_;
  std::string item_;
  std::size_t most_frames_ = 0;
  std::size_t frame_items_ = 0;
  std::size_t frames_made_ = 0;
  std::size_t held_ = 0;
  double tick_ = 0;
  Clock::time_point watched_ = Clock::now();
  bool ended_ = false;
};

Workers::Workers(Work work, const WorkerOptions& options) : pool_(std::make_unique<Pool>(std::move(work), options)) {}
Workers::~Workers() = default;
void Workers::run(const Next& next, const Take& take) { pool_->run(next, take); }
const std::string& Workers::open_because() const { return pool_->open_because(); }

}  // namespace blossom
