/// The look of a document: the looks to choose from, fitted to its scan, edits of the one that is shown, and the mask
/// and the voxels that it takes.

#include <utility>

#include "app/document/document.h"
#include "render/volume/value_unit.h"

namespace pdr::app {

void Document::setLooks(std::vector<NamedLook> looks) {
    looks_.replace(std::move(looks));
    report(plan_, Changes::looks);
}

/// Fits the looks to the volume. A look that the user has changed stays as it is, from one scan in HU to another:
/// values that are no HU mean something else in each scan.
void Document::fitLooksTo(const std::optional<segment::Findings>& findings) {
    const int shown = look();
    const bool wereInHu = looks_.areInHu();
    if (unitOf(*scan()).isHu)
        looks_.fitTo(findings);
    else
        looks_.fitToValues(spreadOf(*scan()));
    const bool stayInHu = wereInHu && looks_.areInHu();
    if (stayInHu && shown < 0)
        return;
    plan_.image = withNamedLook(setup(), looks_[looks_.suitedOr(stayInHu ? shown : 0)], bodyBox());
    plan_.image.stops = 0;
}

void Document::suggestBrightness(int look, double stops) {
    if (!hasVolume() || !looks_.holds(look) || !looks_.suggestStops(look, stops))
        return;
    if (look != this->look() || setup().stops != 0)
        return;
    const Plan before = plan_;
    history_.brighten(setup().lookName, stops);  // so that undo does not lead back to a brightness that nobody chose
    plan_.image.stops = stops;
    report(before);
}

/// Returns the setup without the cut of `look`; -1: no look, nothing is removed.
ImageSetup Document::withoutCutOf(int look) const {
    ImageSetup setup = this->setup();
    if (look >= 0 && looks_[look].cut && hasVolume())
        std::erase(setup.clip.planes, planeOf(*looks_[look].cut, bodyBox()));
    return setup;
}

ImageSetup Document::setupWith(int look) const {
    ImageSetup setup = withNamedLook(withoutCutOf(this->look()), looks_[look], bodyBox());
    setup.stops = looks_.stops(look);
    if (!hasVolume())
        setup.clip = {};  // open() applies the look's cut
    return setup;
}

void Document::chooseLook(int index) {
    if (!looks_.holds(index))
        return;
    edit(setupWith(index));
}

void Document::setLook(const Look& look, bool moving) {
    ImageSetup setup = plan_.image;
    setup.look = look;
    edit(looks_.named(std::move(setup), plan_.image.lookName), Changes::look, moving);
}

void Document::setVisible(const Visible& visible, bool moving) {
    Look look = setup().look;
    look.visible = visible;
    setLook(look, moving);
}

void Document::setMask(const Visible& visible, const std::shared_ptr<const Mask>& mask) {
    if (!mask)
        return visible == setup().look.visible ? fallBackTo(Visible{}) : void();
    if (!hasVolume())
        return;
    scan_.masks().add(visible, mask);
    if (visible == setup().look.visible)
        showArrived();
}

void Document::keepVisible() {
    fallBackTo(scan_.masks().shown());
}

void Document::setCtDenoised(bool denoised) {
    Look look = setup().look;
    look.ctDenoised = denoised;
    setLook(look);
}

void Document::takeDenoisedCt(const std::shared_ptr<const Volume>& scan,
                              const std::shared_ptr<const Volume>& denoised) {
    if (!hasVolume() || scan != seen())
        return;
    scan_.denoised().take(scan, denoised);
    if (setup().look.ctDenoised)
        showArrived();
}

void Document::keepNoise() {
    Look look = setup().look;
    look.ctDenoised = false;
    fallBackTo(look);
}

void Document::fallBackTo(const Visible& visible) {
    Look look = setup().look;
    look.visible = visible;
    fallBackTo(look);
}

void Document::fallBackTo(const Look& look) {
    Plan plan = plan_;
    plan.image.look = look;
    plan.image = looks_.named(std::move(plan.image), setup().lookName);
    fallBackTo(std::move(plan));
}

}  // namespace pdr::app
