#pragma once
/// A picture in the making, kept where its device adds samples fastest.
///   iterate, show, iterate, show, ...   orders; the work may go on behind the caller's back
///   take                                hands out the pictures ordered by show(), oldest first

#include <cstdint>
#include <memory>
#include <stop_token>

#include "render/base/result.h"
#include "render/film/tone_map.h"

namespace pdr {

class LiveFilm {
  public:
    virtual ~LiveFilm() = default;

    /// Takes n more samples of every pixel of the uploaded scene. After a stop request it returns early and the film is
    /// worthless. Errors: the device's.
    virtual Result<void> iterate(std::uint32_t n, std::stop_token stop) = 0;
    /// Orders a picture of what is there, tone mapped. At most ahead() may be waiting to be taken.
    virtual Result<void> show(const Display& display) = 0;
    /// The oldest picture that was ordered; waits for it. One must have been ordered.
    virtual Result<Picture> take() = 0;
    /// Pictures that may be ordered before the first is taken: 1 where nothing goes on behind, else more.
    virtual int ahead() const = 0;

    /// All that is known, on the host. Pictures ordered stay ordered.
    virtual Result<std::shared_ptr<const Film>> film() = 0;
    /// Goes on from `film`, of the same size, as if all its samples had been taken here.
    virtual Result<void> resume(const Film& film) = 0;
};

}  // namespace pdr
