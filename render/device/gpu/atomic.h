#pragma once
/// Atomic operations of a program's threads on the same number. In any order the result is the same.

#include <atomic>
#include <cstdint>

#include "render/base/portable.h"

namespace pdr {

/// Adds `value` to `target`; returns the value before.
PDR_HD inline std::uint64_t atomicAddTo(std::uint64_t& target, std::uint64_t value) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(reinterpret_cast<unsigned long long*>(&target), static_cast<unsigned long long>(value));
#else
    return std::atomic_ref(target).fetch_add(value, std::memory_order_relaxed);
#endif
}

PDR_HD inline void atomicAddTo(std::uint32_t& target, std::uint32_t value) {
#if defined(__CUDA_ARCH__)
    atomicAdd(&target, value);
#else
    std::atomic_ref(target).fetch_add(value, std::memory_order_relaxed);
#endif
}

/// Sets bits that are mostly set already; if they are, no thread waits for another.
PDR_HD inline void atomicMark(std::uint32_t& target, std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    if ((*const_cast<volatile std::uint32_t*>(&target) & bits) != bits)
        atomicOr(&target, bits);
#else
    std::atomic_ref shared(target);
    if ((shared.load(std::memory_order_relaxed) & bits) != bits)
        shared.fetch_or(bits, std::memory_order_relaxed);
#endif
}

PDR_HD inline void atomicLower(std::uint64_t& target, std::uint64_t value) {
#if defined(__CUDA_ARCH__)
    atomicMin(reinterpret_cast<unsigned long long*>(&target), static_cast<unsigned long long>(value));
#else
    std::atomic_ref shared(target);
    std::uint64_t before = shared.load(std::memory_order_relaxed);
    while (value < before && !shared.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
    }
#endif
}

/// Lowers a bound that is mostly low enough already; if it is, no thread waits for another. atomicRaise() raises one.
PDR_HD inline void atomicLower(std::int32_t& target, std::int32_t value) {
#if defined(__CUDA_ARCH__)
    if (value < *const_cast<volatile std::int32_t*>(&target))
        atomicMin(&target, value);
#else
    std::atomic_ref shared(target);
    std::int32_t before = shared.load(std::memory_order_relaxed);
    while (value < before && !shared.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
    }
#endif
}

PDR_HD inline void atomicRaise(std::int32_t& target, std::int32_t value) {
#if defined(__CUDA_ARCH__)
    if (value > *const_cast<volatile std::int32_t*>(&target))
        atomicMax(&target, value);
#else
    std::atomic_ref shared(target);
    std::int32_t before = shared.load(std::memory_order_relaxed);
    while (value > before && !shared.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
    }
#endif
}

/// Adds 1 to `target`; returns the value before.
PDR_HD inline std::int32_t atomicTakeNext(std::int32_t& target) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(&target, 1);
#else
    return std::atomic_ref(target).fetch_add(1, std::memory_order_relaxed);
#endif
}

}  // namespace pdr
