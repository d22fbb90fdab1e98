#pragma once
/// Events of several paths, gathered so that their light is sought in lanes.

#include <array>
#include <cstring>

#include "render/kernel/transport/direct_light.h"

namespace pdr {

/// One structure of floats for each lane. Of<float> and Of<FloatLanes> have the same members in the same order.
template <template <class> class Of>
class LaneColumns {
  public:
    LaneColumns() = default;
    explicit LaneColumns(const Of<FloatLanes>& all) { std::memcpy(&columns_, &all, sizeof all); }

    Of<FloatLanes> all() const {
        Of<FloatLanes> all;
        std::memcpy(&all, &columns_, sizeof all);
        return all;
    }
    void set(int lane, const Of<float>& one) {
        Row row;
        std::memcpy(&row, &one, sizeof one);
        for (std::size_t i = 0; i < kNumbers; ++i)
            columns_[i][std::size_t(lane)] = row[i];
    }
    Of<float> at(int lane) const {
        Row row;
        for (std::size_t i = 0; i < kNumbers; ++i)
            row[i] = columns_[i][std::size_t(lane)];
        Of<float> one;
        std::memcpy(&one, &row, sizeof one);
        return one;
    }

  private:
    static constexpr std::size_t kNumbers = sizeof(Of<float>) / sizeof(float);
    static_assert(sizeof(Of<FloatLanes>) == kNumbers * sizeof(FloatLanes));
    using Row = std::array<float, kNumbers>;

    alignas(64) std::array<std::array<float, kLanes>, kNumbers> columns_{};
};

/// As many events as there are lanes, with the random numbers for the light path from each.
class EventGroup {
  public:
    /// Number `event` of the events on the segment of a row.
    struct Place {
        int row, event;
    };

    int size() const { return size_; }
    bool isFull() const { return size_ == kLanes; }
    void clear() { size_ = 0; }
    void add(Place place, const Event& event, const LightNumbers& numbers) {
        places_[std::size_t(size_)] = place;
        events_.set(size_, event);
        numbers_.set(size_++, numbers);
    }

    Place place(int lane) const { return places_[std::size_t(lane)]; }
    vec3 emission(int lane) const { return events_.at(lane).material.emission; }
    EventOf<FloatLanes> all() const { return events_.all(); }
    LightNumbersOf<FloatLanes> numbers() const { return numbers_.all(); }

  private:
    int size_ = 0;
    std::array<Place, kLanes> places_;
    LaneColumns<EventOf> events_;
    LaneColumns<LightNumbersOf> numbers_;
};

}  // namespace pdr
