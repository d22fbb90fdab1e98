#pragma once
/// Reads the map of a message field by field, by ascending keys; keys in between that nobody asks for are skipped. The
/// first thing that is wrong stays what is wrong, and all that is asked for after it is left as it is.
///   keys      unsigned, each higher than the one before, so that none is there twice; at most kMostKeys
///   skipped   whatever it is, kMostDepth deep at most, the map included

#include <QCborStreamReader>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "app/wire/messages.h"

namespace pdr::wire {

inline constexpr int kMostKeys = 32;
inline constexpr int kMostDepth = 4;

class MapReader {
  public:
    explicit MapReader(std::span<const std::byte> map);

    /// Whole, in [low, high].
    template <class Number>
    void number(std::uint64_t key, Number& value, std::uint64_t low = 0, std::uint64_t high = mostOf<Number>()) {
        if (find(key)) {
            value = Number(readNumber(low, high));
            readKey();
        }
    }
    /// As many as there are places for.
    template <class Number, std::size_t n>
    void numbers(std::uint64_t key, const std::array<Number*, n>& values, std::uint64_t low = 0,
                 std::uint64_t high = mostOf<Number>()) {
        if (!find(key))
            return;
        enterArray(n);
        for (Number* value : values)
            *value = Number(readNumber(low, high));
        leaveArray();
    }
    /// Finite.
    void real(std::uint64_t key, double& value, double low, double high);
    void reals(std::uint64_t key, std::span<double> values);
    /// Exactly so many.
    void bytes(std::uint64_t key, std::span<std::byte> value);
    /// A line (line.h).
    void text(std::uint64_t key, std::string& value, std::size_t mostBytes);

    /// A line, and where `partsKey` is there what it was made of: a sender of an earlier version has no parts.
    void phrase(std::uint64_t key, std::uint64_t partsKey, Text& text);

    /// Makes a value where `key` is there, and tells so.
    template <class T>
    bool optional(std::uint64_t key, std::optional<T>& value) {
        if (isNext(key))
            value.emplace();
        return value.has_value();
    }
    void must(bool right, const char* wrong) {
        if (!right)
            fail(wrong);
    }

    /// What is wrong; null: nothing. Reads to the end, behind which nothing may be.
    const char* finish();

  private:
    template <class Number>
    static constexpr std::uint64_t mostOf() {
        return std::uint64_t(std::numeric_limits<Number>::max());
    }
    bool failed() const { return wrong_ != nullptr; }
    void fail(const char* wrong);
    void readKey();
    bool isNext(std::uint64_t key);
    bool find(std::uint64_t key);
    void skip(int depth = 0);
    std::uint64_t readNumber(std::uint64_t low, std::uint64_t high);
    double readReal(double low, double high);
    void enterArray(std::size_t length);
    void leaveArray();
    /// Of the string of that type that is next; 0 where there is none of up to `most` bytes.
    std::size_t stringBytes(QCborStreamReader::Type type, std::size_t most);
    void readString(void* into, std::size_t bytes);

    QCborStreamReader cbor_;
    qint64 mapBytes_;
    std::optional<std::uint64_t> key_;  ///< whose value is next
    int keys_ = 0;
    const char* wrong_ = nullptr;
};

}  // namespace pdr::wire
