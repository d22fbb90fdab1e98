#include "ui/tissue/curve_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pdr::ui {
namespace {

constexpr double kReach = 8;      ///< distance from which the pointer reaches a point [px]
constexpr double kLineReach = 5;  ///< distance from which the pointer reaches the line [px]
constexpr double kTremble = 3;    ///< pointer movement that still counts as a click [px]

double length(QPointF vector) {
    return std::hypot(vector.x(), vector.y());
}

}  // namespace

void CurveHand::setCurve(const Curve& curve, float top) {
    top_ = top;
    if (curve == curve_)
        return;
    if (curve.size() != curve_.size())
        selection_.clear();
    curve_ = curve;
    holding_ = Holding::nothing;
}

std::optional<std::size_t> CurveHand::pointAt(const PlotView& view, QPointF place) const {
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t i = 0; i < curve_.size(); ++i) {
        QPointF distance = view.at(double(curve_[i].hu), double(curve_[i].value)) - place;
        if (kind_ == Kind::level)
            distance.setY(0);
        if (length(distance) <= least) {  // of points at one place, take the last: it can move right
            least = length(distance);
            nearest = i;
        }
    }
    return nearest;
}

/// Returns whether `place` is on the curve; a vertical step belongs to the line.
bool CurveHand::isOnLine(const PlotView& view, QPointF place) const {
    if (kind_ == Kind::level)
        return false;
    const auto heightAt = [&](double x) { return view.y(double(valueAt(curve_, float(view.hu(x))))); };
    const auto [lowest, highest] =
        std::minmax({heightAt(place.x() - kLineReach / 2), heightAt(place.x()), heightAt(place.x() + kLineReach / 2)});
    return place.y() >= lowest - kLineReach && place.y() <= highest + kLineReach;
}

bool CurveHand::press(const PlotView& view, QPointF place, Qt::KeyboardModifiers keys) {
    changed_ = dragged_ = false;
    from_ = to_ = place;
    // Select or deselect the point under the pointer
    const bool several = keys.testFlag(Qt::ShiftModifier), anywhere = keys.testFlag(Qt::ControlModifier);
    if (const auto point = pointAt(view, place); point && !anywhere) {
        const auto known = std::lower_bound(selection_.begin(), selection_.end(), *point);
        const bool selected = known != selection_.end() && *known == *point;
        if (several && selected)
            return selection_.erase(known), false;
        if (several)
            selection_.insert(known, *point);
        else if (!selected)
            selection_ = {*point};
        return hold(*point, place), false;
    }
    // Add a point
    if (anywhere || (isOnLine(view, place) && !several)) {
        const auto hu = float(view.rounded(view.hu(place.x())));
        const float value = anywhere ? float(view.value(place.y())) : valueAt(curve_, hu);
        add({hu, value});
        hold(selection_.front(), place);
        return changed_ = true;
    }
    // Begin a rubber band
    keeping_ = several ? selection_ : CurveSelection();
    selection_ = keeping_;
    holding_ = Holding::band;
    return false;
}

void CurveHand::hold(std::size_t point, QPointF place) {
    holding_ = Holding::points;
    held_ = point;
    from_ = place;
    before_ = curve_;
}

bool CurveHand::drag(const PlotView& view, QPointF place) {
    if (holding_ == Holding::nothing)
        return false;
    to_ = place;
    dragged_ = dragged_ || length(to_ - from_) >= kTremble;
    if (!dragged_)
        return false;
    if (holding_ == Holding::band) {
        selection_ = inside(view, *band());
        return false;
    }
    const double hu = double(before_[held_].hu) + (to_.x() - from_.x()) * view.huPerPixel();
    const double rounded = view.rounded(hu);
    const bool change = become(
        moved(before_, selection_,
              {float(rounded - double(before_[held_].hu)), float(view.value(to_.y()) - view.value(from_.y()))}, top_));
    changed_ = changed_ || change;
    return change;
}

bool CurveHand::release() {
    holding_ = Holding::nothing;
    return std::exchange(changed_, false);
}

std::optional<QRectF> CurveHand::band() const {
    if (holding_ != Holding::band || !dragged_)
        return std::nullopt;
    return QRectF(from_, to_).normalized();
}

CurveSelection CurveHand::inside(const PlotView& view, const QRectF& band) const {
    CurveSelection all = keeping_;
    for (std::size_t i = 0; i < curve_.size(); ++i) {
        const QPointF place = view.at(double(curve_[i].hu), double(curve_[i].value));
        if (place.x() >= band.left() && place.x() <= band.right() &&
            (kind_ == Kind::level || (place.y() >= band.top() && place.y() <= band.bottom())))
            all.push_back(i);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

bool CurveHand::become(Curve curve) {
    if (curve == curve_)
        return false;
    curve_ = std::move(curve);
    return true;
}

bool CurveHand::nudge(CurvePoint by) {
    return !selection_.empty() && become(moved(curve_, selection_, by, top_));
}

bool CurveHand::removeSelected() {
    if (selection_.empty() || !become(without(curve_, selection_)))
        return false;
    const std::size_t next = std::min(selection_.front(), curve_.size() - 1);
    selection_ = {next};
    return true;
}

void CurveHand::addAfterSelected() {
    const std::size_t i = selection_.empty() ? 0 : selection_.back();
    const CurvePoint& here = curve_[i];
    constexpr float kBeyond = 100;  // beyond the last point [HU]
    const float next = i + 1 < curve_.size() ? curve_[i + 1].hu : std::min(here.hu + 2 * kBeyond, kHighestHu);
    const float hu = (here.hu + next) / 2;
    add({hu, valueAt(curve_, hu)});
}

void CurveHand::add(const CurvePoint& point) {
    const CurvePoint inside{std::clamp(point.hu, kLowestHu, kHighestHu), std::clamp(point.value, 0.0f, top_)};
    selection_ = {insertPoint(curve_, inside)};
}

void CurveHand::selectAll() {
    selection_.clear();
    for (std::size_t i = 0; i < curve_.size(); ++i)
        selection_.push_back(i);
}

void CurveHand::selectNext(int step) {
    const auto last = std::ptrdiff_t(curve_.size()) - 1;
    const std::ptrdiff_t before = step > 0 ? -1 : last + 1;
    const std::ptrdiff_t now =
        selection_.empty() ? before : std::ptrdiff_t(step > 0 ? selection_.back() : selection_.front());
    selection_ = {std::size_t(std::clamp<std::ptrdiff_t>(now + step, 0, last))};
}

}  // namespace pdr::ui
