#pragma once
/// Reads the map of a message field by field, by ascending keys. Fields that are not read are skipped. The first error
/// is kept, and reads after it leave their values unchanged.
///   keys      unsigned, each higher than the one before, so that none occurs twice; at most kMostKeys
///   skipped   fields of any type, nested at most kMostDepth deep, the map included

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

    /// Reads a whole number in [low, high].
    template <class Number>
    void number(std::uint64_t key, Number& value, std::uint64_t low = 0, std::uint64_t high = mostOf<Number>()) {
        if (find(key)) {
            value = Number(readNumber(low, high));
            readKey();
        }
    }
    /// Reads an array of exactly n whole numbers in [low, high].
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
    /// Reads a finite number in [low, high].
    void real(std::uint64_t key, double& value, double low, double high);
    /// Reads an array of exactly as many finite numbers as `values` has.
    void reals(std::uint64_t key, std::span<double> values);
    /// Reads a sequence of exactly as many bytes as `value` has.
    void bytes(std::uint64_t key, std::span<std::byte> value);
    /// Reads a line (line.h) of at most `mostBytes`.
    void text(std::uint64_t key, std::string& value, std::size_t mostBytes);

    /// Reads a line and, if `partsKey` is present, its parts (text_parts.h): senders of an earlier version send none.
    void phrase(std::uint64_t key, std::uint64_t partsKey, Text& text);

    /// Makes a value if `key` is present. Returns whether there is a value.
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

    /// Reads to the end of the map, which nothing may follow. Returns what is wrong; null: nothing.
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
    /// Returns the length of the next string; fails and returns 0 if it is not of that type or longer than `most`
    /// bytes.
    std::size_t stringBytes(QCborStreamReader::Type type, std::size_t most);
    void readString(void* into, std::size_t bytes);

    QCborStreamReader cbor_;
    qint64 mapBytes_;
    std::optional<std::uint64_t> key_;  ///< key of the next value; none: at the end, or after an error
    int keys_ = 0;
    const char* wrong_ = nullptr;
};

}  // namespace pdr::wire
