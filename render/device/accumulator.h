#pragma once
/// An image in progress, or a part of one, kept where its device adds samples fastest.
///   accumulate, resolve, accumulate, ...   requests; the work may continue after they return
///   readback                               returns the images that resolve() requested, oldest first
///   restart                                begins the next scene, in the same memory

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <utility>

#include "render/base/result.h"
#include "render/film/display/tone_map.h"

namespace pdr {

/// How much one call of accumulate() should request if nothing else limits it.
struct OrderSize {
    double seconds = 0.25;  ///< short, so that Ctrl-C and time limits take effect soon
    std::uint32_t samples = kSamplesPerBlock;
    /// Samples that one call may request however long they take, since a stop request ends extend() soon and leaves a
    /// valid film; 0: there is no such number.
    std::uint32_t whole = 0;
    /// Whether other machines have a part of each request now: the sums of its pixels travel, so that few requests of
    /// many samples are better than many of few.
    bool isShared = false;
};

/// Receives the samples of a film while it is extended: on the thread that extends it, several times a second.
using Extended = std::function<void(const SampleCounts&)>;

/// Keys of the machines whose samples a film holds although this machine has not taken all of them again: if one of
/// them turns out to lie, the film is worthless.
using Contributors = std::set<std::string>;

class Accumulator {
  public:
    virtual ~Accumulator() = default;

    /// Returns how much one call should request. It is more where many machines share a request, since towards its end
    /// some of them have nothing to do.
    virtual OrderSize orderSize() const { return {}; }

    /// Returns the part of the image that it holds.
    virtual Tile area() const = 0;
    /// Takes n more samples of every pixel of `region`, of the uploaded scene. `region` is a part of area(); it is
    /// rounded outwards to whole cells (film/tile_progress.h). After a stop request it returns early, and the film is
    /// invalid until restart(). Errors: the device's, or that it cannot render less than the whole area.
    virtual Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) = 0;
    /// Takes n more samples of every pixel of the whole area.
    Result<void> accumulate(std::uint32_t n, std::stop_token stop) { return accumulate(area(), n, std::move(stop)); }
    /// Takes n more samples of the whole area, which has `had`, and returns how many samples each pixel has then: had +
    /// n; 0 if earlier samples were found wrong and all were discarded (accumulate() takes discarded samples again
    /// before it returns); fewer after a stop request if orderSize().whole is not 0: then the film is valid, and cells
    /// that were finished have more. `told` is called meanwhile where that may take long.
    virtual Result<std::uint64_t> extend(std::uint64_t had, std::uint32_t n, std::stop_token stop,
                                         const Extended& /*told*/ = {}) {
        if (Result<void> done = accumulate(n, std::move(stop)); !done)
            return done.error();
        return had + n;
    }
    /// Requests a tone-mapped image of the current film; the image says whether it is denoised. At most maxInFlight()
    /// images may wait for readback(). After a stop request a denoised image is invalid.
    virtual Result<void> resolve(const Display& display, std::stop_token stop) = 0;
    Result<void> resolve(const Display& display) { return resolve(display, {}); }
    /// Returns the oldest image that was requested; waits for it. At least one must have been requested.
    virtual Result<Image> readback() = 0;
    /// Returns how many images may be requested before the first is read back: 1 if nothing runs asynchronously, else
    /// more.
    virtual int maxInFlight() const = 0;

    /// Returns the whole film, on the host. Requested images stay requested.
    virtual Result<std::shared_ptr<const Film>> film() = 0;
    /// Passes the content of film() to `use`, without a copy if it lies on the host.
    virtual Result<void> look(const std::function<void(const Film&)>& use) {
        const Result<std::shared_ptr<const Film>> known = film();
        if (!known)
            return known.error();
        use(**known);
        return {};
    }
    /// Returns the whole film, on the host, and is without one until restart(). A film on the host is moved, not
    /// copied.
    virtual Result<std::shared_ptr<const Film>> putAway() { return film(); }
    /// Continues from `film`, of the same area, as if all its samples had been taken here.
    virtual Result<void> resume(const Film& film) = 0;
    /// Returns the contributors to the film; none: this machine alone has taken it.
    virtual Contributors contributors() const { return {}; }
    /// Adds contributors to a film from which this one continues.
    virtual void credit(const Contributors& /*contributors*/) {}
    /// Empties the film for the scene of that revision, which was uploaded before; forgets requested images. Allocates
    /// memory only if there is too little. Errors: not enough memory.
    virtual Result<void> restart(const Tile& area, std::uint64_t revision) = 0;
};

}  // namespace pdr
