#pragma once
/// A picture in the making, or a part of one, kept where its device adds samples fastest.
///   accumulate, resolve, accumulate, ...   orders; the work may go on behind the caller's back
///   readback                               hands out the pictures ordered by resolve(), oldest first
///   restart                                the next scene, in the same memory

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <utility>

#include "render/base/result.h"
#include "render/film/display/tone_map.h"

namespace pdr {

/// How much one call of accumulate() should ask for, where nothing else bounds it.
struct OrderSize {
    double seconds = 0.25;  ///< so that Ctrl-C and time limits are obeyed soon
    std::uint32_t samples = kSamplesPerBlock;
};

class Accumulator {
  public:
    virtual ~Accumulator() = default;

    /// More where many share an order out: towards its end some of them have nothing to do.
    virtual OrderSize orderSize() const { return {}; }

    /// The part of the image that it holds.
    virtual Tile area() const = 0;
    /// Takes n more samples of every pixel of `region`, a part of area() that is rounded outwards to whole cells
    /// (film/tile_progress.h), of the uploaded scene. After a stop request it returns early and the film is worthless
    /// until restart(). Errors: the device's, and where it cannot take less than the whole area.
    virtual Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) = 0;
    /// Of the whole area.
    Result<void> accumulate(std::uint32_t n, std::stop_token stop) { return accumulate(area(), n, std::move(stop)); }
    /// Takes n more samples of the whole area, which has `had`, and returns how many it has then: had + n; or 0 where
    /// samples of before were found wrong, and all are thrown away. accumulate() takes those again before it returns.
    virtual Result<std::uint64_t> extend(std::uint64_t had, std::uint32_t n, std::stop_token stop) {
        if (Result<void> done = accumulate(n, std::move(stop)); !done)
            return done.error();
        return had + n;
    }
    /// Orders a picture of what is there, tone mapped; whether it is smoothed, the picture says. At most maxInFlight()
    /// may be waiting to be read back. After a stop request a smoothed one is worthless.
    virtual Result<void> resolve(const Display& display, std::stop_token stop) = 0;
    Result<void> resolve(const Display& display) { return resolve(display, {}); }
    /// The oldest picture that was ordered; waits for it. One must have been ordered.
    virtual Result<Picture> readback() = 0;
    /// Pictures that may be ordered before the first is taken: 1 where nothing goes on behind, else more.
    virtual int maxInFlight() const = 0;

    /// All that is known, on the host. Pictures ordered stay ordered.
    virtual Result<std::shared_ptr<const Film>> film() = 0;
    /// Lets `use` see what film() knows; where that lies on the host, without a copy.
    virtual Result<void> look(const std::function<void(const Film&)>& use) {
        const Result<std::shared_ptr<const Film>> known = film();
        if (!known)
            return known.error();
        use(**known);
        return {};
    }
    /// Goes on from `film`, of the same area, as if all its samples had been taken here.
    virtual Result<void> resume(const Film& film) = 0;
    /// Empties it for the scene of that revision, uploaded before; pictures that were ordered are forgotten. Memory is
    /// taken only where there is too little. Errors: no room for it.
    virtual Result<void> restart(const Tile& area, std::uint64_t revision) = 0;
};

}  // namespace pdr
