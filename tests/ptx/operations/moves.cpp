/// mov, selp and the logic of predicates.

#include "tests/ptx/operations/lanes.h"
#include "tests/ptx/operations/operations.h"

namespace pdr::ptx {

namespace {

template <class T>
void select(Warp& w, const Instruction& i) {
    const auto *a = w.at<T>(i.from[0]), *b = w.at<T>(i.from[1]);
    const u32 first = w.predicates[i.from[2]];
    setLanes<T>(w, i.to[0], [&](int l) { return (first >> l & 1) != 0 ? a[l] : b[l]; });
}

template <auto F>
void combine(Warp& w, const Instruction& i) {
    const u32 a = w.predicates[i.from[0]], b = i.from[1] == kNone ? 0 : w.predicates[i.from[1]];
    w.setPredicate(i.to[0], F(a, b));
}

}  // namespace

Operation choice(Type type) {
    return bitsOf(type) == 64 ? &select<u64> : &select<u32>;
}

Operation copy(u32 bits) {
    return bits == 64 ? &unary<u64, u64, [](u64 x) { return x; }> : &unary<u32, u32, [](u32 x) { return x; }>;
}

Operation joinHalves() {
    return &binary<u64, u32, u32, [](u32 low, u32 high) { return u64(high) << 32 | low; }>;
}

Operation cutIntoHalves() {
    return [](Warp& w, const Instruction& i) {
        const auto* a = w.at<u64>(i.from[0]);
        if (i.to[0] != kNone)
            setLanes<u32>(w, i.to[0], [&](int l) { return u32(a[l]); });
        if (i.to[1] != kNone)
            setLanes<u32>(w, i.to[1], [&](int l) { return u32(a[l] >> 32); });
    };
}

Operation predicateLogic(const Mnemonic& what) {
    if (what.base == "and")
        return &combine<[](u32 a, u32 b) { return a & b; }>;
    if (what.base == "or")
        return &combine<[](u32 a, u32 b) { return a | b; }>;
    if (what.base == "xor")
        return &combine<[](u32 a, u32 b) { return a ^ b; }>;
    if (what.base == "not")
        return &combine<[](u32 a, u32) { return ~a; }>;
    if (what.base == "mov")
        return &combine<[](u32 a, u32) { return a; }>;
    return nullptr;
}

}  // namespace pdr::ptx
