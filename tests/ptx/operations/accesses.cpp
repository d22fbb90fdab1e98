/// ld and st: of global, local and parameter memory, and cvta of local addresses.

#include <bit>
#include <cstring>
#include <type_traits>

#include "tests/ptx/operations/by_type.h"
#include "tests/ptx/operations/operations.h"
#include "tests/ptx/operations/places.h"

namespace pdr::ptx {

namespace {

u8* parameterPlace(Warp& w, const Instruction& i, int lane, u64 address) {
    const std::span<u8> parameters = w.launch->parameters;
    const u64 at = i.from[0] == kNone ? address : address - reinterpret_cast<u64>(parameters.data());
    if (at + u64(i.bytes) * i.count > parameters.size())
        w.fault(i, lane, kIllegalAddress, "behind the parameters");
    return parameters.data() + at;
}

template <Space S>
u8* placeOf(Warp& w, const Instruction& i, int lane, Access access) {
    const u64 address = addressOf(w, i, lane);
    if constexpr (S == Space::local)
        return localPlace(w, i, lane, address);
    if constexpr (S == Space::parameter)
        return parameterPlace(w, i, lane, address);
    if (S == Space::generic && address >= kLocalWindow)
        return localPlace(w, i, lane, address - kLocalWindow);
    return globalPlace(w, i, lane, address, access);
}

/// A number as it lies in a register of R: signs are carried on.
template <class R, class T>
R inRegister(T value, bool isNarrow) {
    using Wide = std::conditional_t<std::is_signed_v<T>, std::make_signed_t<R>, R>;
    return R(Wide(value)) & (isNarrow ? R(0xFFFF) : R(~R(0)));
}

/// IsNarrow: the register has 16 bits.
template <Space S, class T, class R, bool IsNarrow>
void loadInto(Warp& w, const Instruction& i) {
    forLanes(w, [&](int lane) {
        const u8* place = placeOf<S>(w, i, lane, i.isVolatile ? Access::relaxedRead : Access::read);
        for (int n = 0; n < i.count; ++n) {
            T value;
            std::memcpy(&value, place + std::size_t(n) * sizeof(T), sizeof(T));
            if (i.to[std::size_t(n)] != kNone)
                w.at<R>(i.to[std::size_t(n)])[lane] = inRegister<R>(value, IsNarrow);
        }
    });
}

template <Space S, class T>
void storeFrom(Warp& w, const Instruction& i) {
    using R = std::conditional_t<sizeof(T) == 8, u64, u32>;
    forLanes(w, [&](int lane) {
        u8* place = placeOf<S>(w, i, lane, i.isVolatile ? Access::atomic : Access::write);
        for (int n = 0; n < i.count; ++n) {
            const T value = T(w.at<R>(i.from[std::size_t(1 + n)])[lane]);
            std::memcpy(place + std::size_t(n) * sizeof(T), &value, sizeof(T));
        }
    });
}

template <Space S>
Operation loadFrom(Type type, u32 registerBits) {
    const auto pick = [&]<class T>() -> Operation {
        if constexpr (sizeof(T) == 8)
            return &loadInto<S, T, u64, false>;
        else
            return registerBits == 64   ? &loadInto<S, T, u64, false>
                   : registerBits == 32 ? &loadInto<S, T, u32, false>
                                        : &loadInto<S, T, u32, true>;
    };
    const Operation ofNumbers = ofInteger(type, pick);
    return ofNumbers != nullptr ? ofNumbers : ofBits(type, pick);
}

template <Space S>
Operation storeTo(Type type) {
    return ofBits(type, []<class T>() -> Operation { return &storeFrom<S, T>; });
}

template <bool In>
void shiftByWindow(Warp& w, const Instruction& i) {
    forLanes(w, [&](int lane) {
        const u64 address = w.at<u64>(i.from[0])[lane];
        w.at<u64>(i.to[0])[lane] = In ? address + kLocalWindow : address - kLocalWindow;
    });
}

}  // namespace

Operation load(Space space, Type type, u32 registerBits) {
    switch (space) {
        case Space::global:
            return loadFrom<Space::global>(type, registerBits);
        case Space::generic:
            return loadFrom<Space::generic>(type, registerBits);
        case Space::local:
            return loadFrom<Space::local>(type, registerBits);
        case Space::parameter:
            return loadFrom<Space::parameter>(type, registerBits);
    }
    return nullptr;
}

Operation store(Space space, Type type) {
    switch (space) {
        case Space::global:
            return storeTo<Space::global>(type);
        case Space::generic:
            return storeTo<Space::generic>(type);
        case Space::local:
            return storeTo<Space::local>(type);
        case Space::parameter:  // a kernel's are not to be written
            break;
    }
    return nullptr;
}

Operation toLocalWindow() {
    return &shiftByWindow<true>;
}

Operation fromLocalWindow() {
    return &shiftByWindow<false>;
}

}  // namespace pdr::ptx
