#pragma once
/// A message of each type, with something in every field.

#include <cstring>
#include <numeric>

#include "app/wire/message_codec.h"

namespace pdr::test {

template <std::size_t n>
std::array<std::byte, n> counting(int first) {
    std::array<std::byte, n> bytes;
    for (std::size_t i = 0; i < n; ++i)
        bytes[i] = std::byte(first + int(i));
    return bytes;
}

/// Returns sums of pixels that have nothing in common with each other.
inline std::vector<PixelSums> unlikeSums(std::size_t pixels) {
    std::vector<PixelSums> sums(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const double x = double(i + 1);
        sums[i] = {.sum = {x, x / 3, 0.5 * x},
                   .sumOfSquares = {x * x, x / 9, 0.25 * x},
                   .evenSum = vec3(0.3f, 0.1f, 0.2f) * float(x),
                   .evenCount = std::uint32_t(i % 7),
                   .count = std::uint32_t(i % 13),
                   .seen = std::uint32_t(i % 4)};
    }
    return sums;
}

inline wire::Hello exampleHello() {
    return {.versions = {1, 3},
            .program = "pdrender-node 0.1.0",
            .name = "gpu-07 übermäßig",
            .boot = counting<16>(1),
            .bits = counting<32>(17),
            .device = "cpu",
            .details = "16 threads",
            .memoryBytes = std::uint64_t(48) << 30};
}

inline wire::SceneOrder exampleOrder() {
    wire::SceneOrder order{.revision = 41,
                           .volume = {counting<32>(3), {512, 511, 300}, {}},
                           .mask = wire::MaskOrder{counting<32>(4), {512, 511, 300}, {1, 1, 0}},
                           .environment = wire::EnvironmentOrder{counting<32>(5), {2048, 1024}},
                           .text = "{\"film\": [512, 512]}"};
    std::iota(order.volume.patientFromIndex.begin(), order.volume.patientFromIndex.end(), -4.75);
    return order;
}

inline wire::Lease exampleLease() {
    return {.number = 77,
            .nonce = counting<16>(9),
            .revision = 41,
            .tile = {64, 128, 5, 3},
            .samples = {200, 24},
            .before = unlikeSums(15)};
}

inline wire::Result exampleResult() {
    wire::Result result{.number = 77,
                        .nonce = counting<16>(9),
                        .revision = 41,
                        .tile = {64, 128, 5, 3},
                        .samples = {200, 24},
                        .sums = unlikeSums(15),
                        .seconds = 1.25};
    for (int i = 0; i < kFaults; ++i)
        result.health.faults[i] = {std::uint64_t(i + 1) << 40, std::uint64_t(200 + i), std::uint32_t(i * 70000)};
    return result;
}

/// Returns moments of pixels that have nothing in common with each other.
inline std::vector<Moments> unlikeMoments(std::size_t pixels) {
    std::vector<Moments> moments(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const double x = double(i + 1);
        moments[i] = {.mean = {x, x / 3, 0.5 * x},
                      .m2 = {x * x, x / 9, 0.25 * x},
                      .count = 256 - i % 13,
                      .evenMean = vec3(0.3f, 0.1f, 0.2f) * float(x),
                      .evenCount = std::uint32_t(128 - i % 7)};
    }
    return moments;
}

/// A lease of several blocks, and its result: version 2 of the protocol.
inline wire::Lease exampleDeepLease() {
    wire::Lease lease = exampleLease();
    lease.samples = {192, 256};
    lease.before.clear();
    lease.moments = unlikeMoments(15);
    return lease;
}
inline wire::Result exampleDeepResult() {
    wire::Result result = exampleResult();
    result.samples = {192, 256};
    for (PixelSums& sums : result.sums)
        sums = {.seen = sums.seen};
    result.moments = unlikeMoments(15);
    return result;
}
inline std::vector<wire::Message> exampleDeepMessages() {
    return {exampleDeepLease(), exampleDeepResult()};
}

/// Sums that stay where they are: an addition to version 2 that both sides may lack.
inline std::vector<wire::Message> exampleKeptMessages() {
    wire::Hello hello = exampleHello();
    hello.keptPixels = 1 << 21;
    wire::Lease lease = exampleLease();
    lease.before.clear();
    lease.kept = counting<32>(50);
    return {hello, lease};
}

inline std::vector<wire::Message> exampleMessages() {
    return {exampleHello(),
            wire::Welcome{1, 2500, counting<32>(100)},
            wire::Refused{wire::Refused::Why::bits, std::string("it rounds in another way")},
            wire::Ping{5},
            wire::Pong{5},
            exampleOrder(),
            wire::Need{counting<32>(3), 17},
            wire::Chunk{counting<32>(3), 2, 9, wire::Bytes(12, std::byte(0x5a))},
            wire::SceneReady{41},
            wire::SceneRefused{41, std::string("there is too little memory")},
            exampleLease(),
            exampleResult(),
            wire::Abandoned{77, counting<16>(9), std::string("the GPU is lost")},
            wire::Draining{},
            wire::Forget{},
            wire::Bye{std::string("the user quits")}};
}

template <class Pixel>
bool sameSums(const std::vector<Pixel>& a, const std::vector<Pixel>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

template <class T>
bool same(const T& a, const T& b) {
    return a == b;
}
template <>
inline bool same(const wire::Lease& a, const wire::Lease& b) {
    return a.number == b.number && a.nonce == b.nonce && a.revision == b.revision && a.tile == b.tile &&
           a.samples == b.samples && a.kept == b.kept && sameSums(a.before, b.before) && sameSums(a.moments, b.moments);
}
template <>
inline bool same(const wire::Result& a, const wire::Result& b) {
    bool healthy = true;
    for (int i = 0; i < kFaults; ++i) {
        const FaultCount &of = a.health.faults[i], &other = b.health.faults[i];
        healthy = healthy && of.count == other.count && of.sample == other.sample && of.pixel == other.pixel;
    }
    return a.number == b.number && a.nonce == b.nonce && a.revision == b.revision && a.tile == b.tile &&
           a.samples == b.samples && sameSums(a.sums, b.sums) && sameSums(a.moments, b.moments) && healthy &&
           a.seconds == b.seconds;
}
template <>
inline bool same(const wire::Message& a, const wire::Message& b) {
    return a.index() == b.index() &&
           std::visit([&](const auto& of) { return same(of, std::get<std::decay_t<decltype(of)>>(b)); }, a);
}

/// Who reads messages of that type; a Bye both.
inline wire::Role readerOf(const wire::Message& message) {
    return wire::kindOf(wire::typeOf(message))->fromNode ? wire::Role::coordinator : wire::Role::node;
}
inline std::string nameOf(const wire::Message& message) {
    return std::string(wire::kindOf(wire::typeOf(message))->name);
}

}  // namespace pdr::test
