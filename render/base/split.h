#pragma once
/// How a picture is shared out among those who take samples for it.

namespace pdr {

enum class Split {
    tiles,   ///< sort-first: parts of the picture
    samples  ///< sample-first: the whole picture, in blocks of samples
};

}  // namespace pdr
