#pragma once
/// Numbers in SIMD lanes. Code written for a type Real runs on float, one path at a time as on a GPU, and on
/// FloatLanes, kLanes paths at a time in the CPU's vector registers:
///   SimdTraits<Real>::Int    whole numbers
///   SimdTraits<Real>::Bits   64 bits
///   SimdTraits<Real>::Mask   true or false in each lane
/// Lanes are independent: the numbers of a lane are the same whatever its neighbours contain.

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "render/base/gather.h"
#include "render/base/portable.h"

#if defined(__AVX2__) && !defined(__CUDACC__)
#include <immintrin.h>
#endif

namespace pdr {

template <class Real>
struct SimdTraits;

template <>
struct SimdTraits<float> {
    using Int = std::int32_t;
    using Bits = std::uint64_t;
    using Mask = bool;
};

PDR_HD inline int toInt(float x) {
    return int(x);
}
PDR_HD inline float toFloat(int x) {
    return float(x);
}
PDR_HD inline bool any(bool mask) {
    return mask;
}
PDR_HD inline bool unfolded(bool mask) {
    return mask;
}
/// Returns the number of lanes in which `mask` holds.
PDR_HD inline int count(bool mask) {
    return mask;
}
PDR_HD inline float gather(const float* from, int index) {
    return from[index];
}
/// Does nothing: a single ray leaves prefetching to the processor.
template <class T>
PDR_HD inline void prefetch(const T*, int) {}
/// Returns column[index]. The column has `count` entries and is readable up to the next multiple of kLanes.
PDR_HD inline float tableLookup(const float* column, int /*count*/, int index) {
    return column[index];
}
/// Returns bits 41..63 of a random word as a whole number below 2^23; lowBits() returns bits 9..31.
PDR_HD inline int highBits(std::uint64_t word) {
    return int(word >> 41);
}
PDR_HD inline int lowBits(std::uint64_t word) {
    return int(std::uint32_t(word) >> 9);
}
PDR_HD inline std::uint64_t masked(bool mask, std::uint64_t word) {
    return mask ? word : 0;
}
PDR_HD inline float squareRoot(float x) {
    return std::sqrt(x);
}
/// Returns the bits of a float; floatOf() is the inverse.
PDR_HD inline std::int32_t bitsOf(float x) {
#if defined(__CUDA_ARCH__)
    return __float_as_int(x);
#else
    return std::bit_cast<std::int32_t>(x);
#endif
}
PDR_HD inline float floatOf(std::int32_t bits) {
#if defined(__CUDA_ARCH__)
    return __int_as_float(bits);
#else
    return std::bit_cast<float>(bits);
#endif
}

#if !defined(__CUDACC__)

using FloatLanes = float __attribute__((vector_size(4 * kLanes)));
using IntLanes = std::int32_t __attribute__((vector_size(4 * kLanes)));
using BitsLanes = std::uint64_t __attribute__((vector_size(8 * kLanes)));
using SignedBitsLanes = std::int64_t __attribute__((vector_size(8 * kLanes)));

template <>
struct SimdTraits<FloatLanes> {
    using Int = IntLanes;
    using Bits = BitsLanes;
    using Mask = IntLanes;
};

inline IntLanes toInt(FloatLanes x) {
    return __builtin_convertvector(x, IntLanes);
}
inline FloatLanes toFloat(IntLanes x) {
    return __builtin_convertvector(x, FloatLanes);
}
/// Returns a word whose bit l is 1 where `mask` holds in lane l.
inline std::uint32_t laneBits(IntLanes mask) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    return _mm512_movepi32_mask(__m512i(mask));
#elif defined(__AVX2__)
    return std::uint32_t(_mm256_movemask_ps(__m256(mask)));
#else
    std::uint32_t bits = 0;
    for (int lane = 0; lane < kLanes; ++lane)
        bits |= std::uint32_t(mask[lane] & 1) << lane;
    return bits;
#endif
}
inline bool any(IntLanes mask) {
    return laneBits(mask) != 0;
}
inline int count(IntLanes mask) {
    return std::popcount(laneBits(mask));
}
#if defined(__clang__)
/// Permutes lanes. Clang's own permutation accepts constants only.
template <class Lanes, class From>
inline Lanes permutedAny(Lanes lanes, From from) {
    Lanes result{};
    for (int lane = 0; lane < kLanes; ++lane)
        result[lane] = lanes[from[lane] & (kLanes - 1)];
    return result;
}
#else
template <class Lanes, class From>
inline Lanes permutedAny(Lanes lanes, From from) {
    return __builtin_shuffle(lanes, from);
}
#endif
/// Returns lanes of which lane l is lane from[l] of `lanes`.
inline FloatLanes permuted(FloatLanes lanes, IntLanes from) {
    return permutedAny(lanes, from);
}
inline IntLanes permuted(IntLanes lanes, IntLanes from) {
    return permutedAny(lanes, from);
}
inline BitsLanes permuted(BitsLanes lanes, IntLanes from) {
    const BitsLanes places = __builtin_convertvector(from, BitsLanes);
#if defined(__clang__)
    return permutedAny(lanes, places);
#else
    // Register by register: GCC permutes what fills two of them number by number.
    using Half = std::uint64_t __attribute__((vector_size(4 * kLanes)));
    struct Halves {
        Half low, high;
    };
    const Halves of = std::bit_cast<Halves>(lanes), at = std::bit_cast<Halves>(places);
    return std::bit_cast<BitsLanes>(
        Halves{__builtin_shuffle(of.low, of.high, at.low), __builtin_shuffle(of.low, of.high, at.high)});
#endif
}
inline BitsLanes selected(IntLanes mask, BitsLanes yes, BitsLanes no) {
    const BitsLanes where = BitsLanes(__builtin_convertvector(mask, SignedBitsLanes));
    return (yes & where) | (no & ~where);
}
/// Returns `mask`, but keeps the compiler from merging it with the masks that it is made of. GCC 12 takes some of those
/// apart bit by bit for AVX-512, in 120 instructions (-Wvector-operation-performance: "expanded piecewise").
inline IntLanes unfolded(IntLanes mask) {
#if defined(__AVX512F__)
    asm("" : "+v"(mask));
#endif
    return mask;
}

/// Returns from[index] in each lane, by one load after the other.
inline FloatLanes gatherOneByOne(const float* from, IntLanes index) {
    FloatLanes result;
    for (int lane = 0; lane < kLanes; ++lane)
        result[lane] = from[index[lane]];
    return result;
}
/// Returns the 32 bits at from + index in each lane: the values at from[index] (low) and from[index + 1].
inline IntLanes gatherPairsOneByOne(const std::int16_t* from, IntLanes index) {
    IntLanes pairs;
    for (int lane = 0; lane < kLanes; ++lane) {
        std::int32_t both;
        std::memcpy(&both, from + index[lane], sizeof both);
        pairs[lane] = both;
    }
    return pairs;
}
/// Variants of both functions in one instruction, where there is one.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline FloatLanes gatherAtOnce(const float* from, IntLanes index) {
    return FloatLanes(_mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xFFFF, __m512i(index), from, 4));
}
inline IntLanes gatherPairsAtOnce(const std::int16_t* from, IntLanes index) {
    return IntLanes(_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xFFFF, __m512i(index), from, 2));
}
#elif defined(__AVX2__)
inline FloatLanes gatherAtOnce(const float* from, IntLanes index) {
    return FloatLanes(_mm256_i32gather_ps(from, __m256i(index), 4));
}
inline IntLanes gatherPairsAtOnce(const std::int16_t* from, IntLanes index) {
    return IntLanes(_mm256_i32gather_epi32(reinterpret_cast<const int*>(from), __m256i(index), 2));
}
#else
inline FloatLanes gatherAtOnce(const float* from, IntLanes index) {
    return gatherOneByOne(from, index);
}
inline IntLanes gatherPairsAtOnce(const std::int16_t* from, IntLanes index) {
    return gatherPairsOneByOne(from, index);
}
#endif

/// Returns the number at `from`, or as many as there are lanes from there on; aligned or not.
template <class Real>
Real load(const float* from) {
    Real value;
    std::memcpy(&value, from, sizeof value);
    return value;
}
/// Writes what load() reads.
template <class Real>
void store(Real value, float* to) {
    std::memcpy(to, &value, sizeof value);
}

inline FloatLanes gather(const float* from, IntLanes index) {
    return kGatherAtOnce ? gatherAtOnce(from, index) : gatherOneByOne(from, index);
}
inline FloatLanes tableLookup(const float* column, int count, IntLanes index) {
    if (count > kLanes)
        return gather(column, index);
    return permuted(load<FloatLanes>(column), index);
}
/// Prefetches the memory at from[index]: lanes read at so many positions that no near cache holds them all. Always
/// inlined: GCC 12 omits the call of a function that does nothing else.
template <class T>
PDR_HD_INLINE void prefetch(const T* from, IntLanes index) {
    for (int lane = 0; lane < kLanes; ++lane)
        __builtin_prefetch(from + index[lane]);
}
/// Reads the int16 values at from[index] into `first` and those at from[index + 1] into `second`.
inline void gatherPair(const std::int16_t* from, IntLanes index, FloatLanes& first, FloatLanes& second) {
    const IntLanes pair = kGatherAtOnce ? gatherPairsAtOnce(from, index) : gatherPairsOneByOne(from, index);
    first = toFloat((pair << 16) >> 16);
    second = toFloat(pair >> 16);
}
inline IntLanes highBits(BitsLanes word) {
    return __builtin_convertvector(word >> 41, IntLanes);
}
inline IntLanes lowBits(BitsLanes word) {
    return __builtin_convertvector((word & 0xFFFFFFFFull) >> 9, IntLanes);
}
inline BitsLanes masked(IntLanes mask, BitsLanes word) {
    return word & BitsLanes(__builtin_convertvector(mask, SignedBitsLanes));
}
inline FloatLanes squareRoot(FloatLanes x) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    return FloatLanes(_mm512_maskz_sqrt_ps(0xFFFF, __m512(x)));
#elif defined(__AVX2__)
    return FloatLanes(_mm256_sqrt_ps(__m256(x)));
#else
    for (int lane = 0; lane < kLanes; ++lane)
        x[lane] = std::sqrt(x[lane]);
    return x;
#endif
}
inline IntLanes bitsOf(FloatLanes x) {
    return IntLanes(x);
}
inline FloatLanes floatOf(IntLanes bits) {
    return FloatLanes(bits);
}

#endif

/// Returns -1 or 1: the sign of a number, or of a zero.
template <class Real>
PDR_HD inline Real signOf(Real x) {
    using Int = typename SimdTraits<Real>::Int;
    constexpr std::int32_t kOne = 0x3F800000, kSign = INT32_MIN;
    return floatOf(Int((bitsOf(x) & kSign) | kOne));
}
/// Returns the number without its sign.
template <class Real>
PDR_HD inline Real magnitude(Real x) {
    using Int = typename SimdTraits<Real>::Int;
    return floatOf(Int(bitsOf(x) & INT32_MAX));
}

template <class Real>
PDR_HD inline Real min(Real a, Real b) {
    return a < b ? a : b;
}
template <class Real>
PDR_HD inline Real max(Real a, Real b) {
    return a > b ? a : b;
}

/// A point, direction or colour; one for each lane if Real is FloatLanes.
template <class Real>
using Vec3 = glm::vec<3, Real>;
template <class Real>
using Vec2 = glm::vec<2, Real>;

template <class Number, class Mask>
PDR_HD_INLINE Vec3<Number> chosen(Mask mask, const Vec3<Number>& yes, const Vec3<Number>& no) {
    return {mask ? yes.x : no.x, mask ? yes.y : no.y, mask ? yes.z : no.z};
}

/// Returns `v`, in every lane if Real is FloatLanes. The sign of zeros stays.
template <class Real>
PDR_HD_INLINE Vec3<Real> everywhere(vec3 v) {
    return {v.x - Real{}, v.y - Real{}, v.z - Real{}};
}

#if !defined(__CUDACC__)

/// What GLM has for vectors of single numbers, for lanes, and with one vector or number for all lanes: in the order of
/// GLM's operations, so that a lane gets the bits that a single vector does.
PDR_HD_INLINE Vec3<FloatLanes> operator*(const Vec3<FloatLanes>& v, float factor) {
    return {v.x * factor, v.y * factor, v.z * factor};
}
PDR_HD_INLINE Vec3<FloatLanes> operator*(const vec3& v, FloatLanes factor) {
    return {v.x * factor, v.y * factor, v.z * factor};
}
PDR_HD_INLINE Vec3<FloatLanes> operator*(const Vec3<FloatLanes>& a, const vec3& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
PDR_HD_INLINE Vec3<FloatLanes> operator/(const Vec3<FloatLanes>& v, float divisor) {
    return {v.x / divisor, v.y / divisor, v.z / divisor};
}
PDR_HD_INLINE Vec3<FloatLanes> operator+(const vec3& a, const Vec3<FloatLanes>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PDR_HD_INLINE Vec3<FloatLanes> operator-(const Vec3<FloatLanes>& a, const vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PDR_HD_INLINE Vec3<FloatLanes> operator-(float a, const Vec3<FloatLanes>& b) {
    return {a - b.x, a - b.y, a - b.z};
}
PDR_HD_INLINE Vec3<FloatLanes> operator*(const mat3& m, const Vec3<FloatLanes>& v) {
    return {m[0][0] * v.x + m[1][0] * v.y + m[2][0] * v.z, m[0][1] * v.x + m[1][1] * v.y + m[2][1] * v.z,
            m[0][2] * v.x + m[1][2] * v.y + m[2][2] * v.z};
}
PDR_HD_INLINE FloatLanes dot(const Vec3<FloatLanes>& a, const Vec3<FloatLanes>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
PDR_HD_INLINE FloatLanes dot(const vec3& a, const Vec3<FloatLanes>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
PDR_HD_INLINE FloatLanes dot(const Vec3<FloatLanes>& a, const vec3& b) {
    return dot(b, a);
}
PDR_HD_INLINE Vec3<FloatLanes> normalize(const Vec3<FloatLanes>& v) {
    return v * (1.0f / squareRoot(dot(v, v)));
}

#endif

/// Returns -ln(u) for u in [2^-24, 1], with a relative error below 3e-7. The arithmetic is the same on every device, so
/// that devices agree bit by bit: ln(2^e m) = e ln 2 + 2 artanh((m - 1) / (m + 1)), m in [0.7, 1.4).
template <class Real>
PDR_HD inline Real negativeLog(Real u) {
    using Int = typename SimdTraits<Real>::Int;
    const Int bits = bitsOf(u);
    const Int exponent = (bits - 0x3F3504F3) >> 23;
    const Real m = floatOf(Int(bits - (exponent << 23)));
    const Real s = (m - 1.0f) / (m + 1.0f);
    const Real s2 = s * s;
    const Real series = 1.0f + s2 * (1.0f / 3 + s2 * (1.0f / 5 + s2 * (1.0f / 7 + s2 * (1.0f / 9))));
    return toFloat(exponent) * -0.69314718f - 2.0f * s * series;
}

}  // namespace pdr
