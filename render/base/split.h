#pragma once
/// How an image is divided among the devices or nodes that sample it.

namespace pdr {

enum class Split {
    tiles,   ///< sort-first: each samples parts of the image
    samples  ///< sample-first: each samples the whole image, in blocks of samples
};

}  // namespace pdr
