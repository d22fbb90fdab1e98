/// vote and shfl: what the lanes of a warp tell each other. They run once all lanes of the mask have come.

#include <array>
#include <cstring>

#include "tests/ptx/operations/operations.h"
#include "tests/ptx/operations/places.h"

namespace pdr::ptx {

namespace {

void ballot(Warp& w, const Instruction& i) {
    const u32 votes = w.predicates[i.from[0]] & w.mask;
    forLanes(w, [&](int lane) { w.at<u32>(i.to[0])[lane] = votes; });
}

template <auto F>
void agree(Warp& w, const Instruction& i) {
    w.setPredicate(i.to[0], F(w.predicates[i.from[0]] & w.mask, w.mask) ? kAllLanes : 0);
}

/// shfl.idx: from[1] is the lane that is taken from, from[2] says which lanes are within reach.
void takeFromLane(Warp& w, const Instruction& i) {
    std::array<u32, kLanes> before;
    std::memcpy(before.data(), w.at<u32>(i.from[0]), sizeof before);
    forLanes(w, [&](int lane) {
        const u32 wanted = w.at<u32>(i.from[1])[lane], reach = w.at<u32>(i.from[2])[lane];
        const u32 segment = reach >> 8 & 31, last = (u32(lane) & segment) | (reach & 31 & ~segment);
        const u32 from = (u32(lane) & segment) | (wanted & 31 & ~segment);
        const bool inside = from <= last;
        if (inside && (w.mask >> from & 1) == 0)
            w.tell(i, "takes from a lane that is not there");
        w.at<u32>(i.to[0])[lane] = before[inside ? from : u32(lane)];
        if (i.to[1] != kNone)
            w.predicates[i.to[1]] = (w.predicates[i.to[1]] & ~(1u << lane)) | u32(inside) << lane;
    });
}

}  // namespace

Operation vote(const Mnemonic& what) {
    if (what.has("ballot"))
        return &ballot;
    if (what.has("any"))
        return &agree<[](u32 votes, u32) { return votes != 0; }>;
    if (what.has("all"))
        return &agree<[](u32 votes, u32 all) { return votes == all; }>;
    if (what.has("uni"))
        return &agree<[](u32 votes, u32 all) { return votes == 0 || votes == all; }>;
    return nullptr;
}

Operation shuffle(const Mnemonic& what) {
    return what.has("idx") ? &takeFromLane : nullptr;
}

}  // namespace pdr::ptx
