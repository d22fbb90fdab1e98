#pragma once
/// Work in streams, done as late, as early or as oddly as CUDA allows, and a judgement of whether what works touch is
/// kept apart by events and waits.

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <unordered_map>
#include <vector>

#include "tests/ptx/base/findings.h"
#include "tests/ptx/base/settings.h"
#include "tests/ptx/machine/access.h"

namespace pdr::ptx {

/// How many works of each stream have certainly ended: a vector clock (Fidge 1988, Mattern 1989). Streams share an
/// entry from the 16th on.
struct Clock {
    std::array<u32, 16> ended{};

    u32& of(std::size_t stream) { return ended[stream % ended.size()]; }
    u32 of(std::size_t stream) const { return ended[stream % ended.size()]; }
    void join(const Clock& other);
};

struct Work {
    std::string what;  ///< "a copy to the host of 8 bytes"
    std::function<void(const Work&)> run;
    std::shared_ptr<Work> after;  ///< in another stream
    std::size_t stream;
    Clock clock{};
    bool isDone = false;
};

class StreamSet {
  public:
    StreamSet(const Settings& settings, Findings& findings)
        : order_(settings.streams), findings_(findings), random_(settings.seed) {}

    std::size_t open();
    std::shared_ptr<Work> add(std::size_t stream, std::string what, std::function<void(const Work&)> run,
                              std::shared_ptr<Work> after = nullptr);
    /// These wait as the host does. They throw what works throw.
    void await(const std::shared_ptr<Work>& work);
    void awaitStream(std::size_t stream);
    void awaitAll();
    /// Work that waits is never done: the device is lost.
    void abandon();

    /// Says that a work reads or writes bytes of the memory `name`, and tells where nothing keeps another stream's work
    /// from them.
    void touches(const Work& work, u64 name, Extent extent, bool writes);

  private:
    struct Touch {
        std::size_t stream;
        Clock clock;
        Extent extent;
        bool writes;
        std::string what;
    };

    void finish(const std::shared_ptr<Work>& work);
    void finishSome();

    Streams order_;
    Findings& findings_;
    std::minstd_rand random_;
    std::vector<std::deque<std::shared_ptr<Work>>> waiting_;
    std::vector<Clock> clocks_;
    Clock host_{};
    std::unordered_map<u64, std::vector<Touch>> touches_;
};

}  // namespace pdr::ptx
