/// atom and red: changes that no other thread comes between.

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <type_traits>

#include "tests/ptx/operations/by_type.h"
#include "tests/ptx/operations/operations.h"
#include "tests/ptx/operations/places.h"

namespace pdr::ptx {

namespace {

/// In what order lanes come is not promised.
std::array<int, kLanes> laneOrder(Warp& w) {
    std::array<int, kLanes> order;
    std::iota(order.begin(), order.end(), 0);
    if (w.launch->settings.warps == Warps::atRandom)
        std::shuffle(order.begin(), order.end(), w.launch->random);
    return order;
}

template <class T, auto F>
void change(Warp& w, const Instruction& i) {
    for (const int lane : laneOrder(w)) {
        if ((w.mask >> lane & 1) == 0)
            continue;
        u8* place = globalPlace(w, i, lane, addressOf(w, i, lane), Access::atomic);
        T before;
        std::memcpy(&before, place, sizeof before);
        const T after = F(before, w.at<T>(i.from[1])[lane]);
        std::memcpy(place, &after, sizeof after);
        if (i.to[0] != kNone)
            w.at<T>(i.to[0])[lane] = before;
    }
}

template <class T>
Operation changeOf(const Mnemonic& what) {
    if (what.has("add"))
        return &change<T, [](T a, T b) { return T(std::make_unsigned_t<T>(a) + std::make_unsigned_t<T>(b)); }>;
    if (what.has("min"))
        return &change<T, [](T a, T b) { return std::min(a, b); }>;
    if (what.has("max"))
        return &change<T, [](T a, T b) { return std::max(a, b); }>;
    if (what.has("or"))
        return &change<T, [](T a, T b) { return T(a | b); }>;
    if (what.has("and"))
        return &change<T, [](T a, T b) { return T(a & b); }>;
    if (what.has("xor"))
        return &change<T, [](T a, T b) { return T(a ^ b); }>;
    if (what.has("exch"))
        return &change<T, [](T, T b) { return b; }>;
    return nullptr;
}

}  // namespace

Operation atomic(const Mnemonic& what) {
    const Type type = what.type();
    if (isFloat(type) || bitsOf(type) < 32)
        return nullptr;
    const auto pick = [&]<class T>() -> Operation {
        if constexpr (sizeof(T) < 4)
            return nullptr;
        else
            return changeOf<T>(what);
    };
    const Operation ofNumbers = ofInteger(type, pick);
    return ofNumbers != nullptr ? ofNumbers : ofBits(type, pick);
}

}  // namespace pdr::ptx
