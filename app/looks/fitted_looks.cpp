#include "app/looks/fitted_looks.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace pdr::app {

FittedLooks::FittedLooks(std::vector<NamedLook> drawn) {
    replace(std::move(drawn));
}

void FittedLooks::replace(std::vector<NamedLook> drawn) {
    assert(!drawn.empty());
    drawn_ = std::move(drawn);
    fit();
}

void FittedLooks::fitTo(const std::optional<segment::Findings>& findings) {
    findings_ = findings;
    spread_.reset();
    fit();
}

void FittedLooks::fitToValues(const ValueSpread& spread) {
    findings_.reset();
    spread_ = spread;
    fit();
}

void FittedLooks::fit() {
    fitted_ = spread_ ? valueLooks(*spread_, drawn_.front()) : drawn_;
    stops_.assign(fitted_.size(), std::nullopt);
    if (findings_ && findings_->blood)
        for (NamedLook& look : fitted_)
            look = fittedTo(std::move(look), *findings_->blood);
}

std::string FittedLooks::whyUnsuited(int look) const {
    return findings_ ? pdr::whyUnsuited((*this)[look], *findings_) : "";
}

int FittedLooks::suitedOr(int look) const {
    if (whyUnsuited(look).empty())
        return look;
    for (int i = 0; holds(i); ++i)
        if (whyUnsuited(i).empty())
            return i;
    return look;
}

int FittedLooks::indexOf(const ImageSetup& setup) const {
    const auto shown = std::ranges::find_if(fitted_, [&](const NamedLook& one) {
        return one.name == setup.lookName && one.look == setup.look && one.model == setup.model;
    });
    return shown == fitted_.end() ? -1 : int(shown - fitted_.begin());
}

ImageSetup FittedLooks::named(ImageSetup setup, const std::string& before) const {
    const auto shown = std::ranges::find_if(
        fitted_, [&](const NamedLook& one) { return one.look == setup.look && one.model == setup.model; });
    setup.lookChanged = shown == fitted_.end();
    setup.lookName = setup.lookChanged ? before : shown->name;
    return setup;
}

const NamedLook* FittedLooks::lookCalled(const std::string& name) const {
    const auto look = std::ranges::find(fitted_, name, &NamedLook::name);
    return look == fitted_.end() ? nullptr : &*look;
}

bool FittedLooks::suggestStops(int look, double stops) {
    std::optional<double>& known = stops_[std::size_t(look)];
    if (known || (*this)[look].group == LookGroup::own)
        return false;
    known = stops;
    return true;
}

}  // namespace pdr::app
