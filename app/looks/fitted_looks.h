#pragma once
/// The looks to choose from, fitted to the current scan: what suits it, and at which brightness.

#include <optional>
#include <string>
#include <vector>

#include "app/looks/value_looks.h"
#include "render/scene/image_setup.h"
#include "render/scene/named_look.h"
#include "render/segment/findings.h"

namespace pdr::app {

class FittedLooks {
  public:
    /// `drawn`: the looks as they were designed, at least one.
    explicit FittedLooks(std::vector<NamedLook> drawn);

    /// The looks fitted to the scan: curves for contrast are moved to the HU of its blood.
    const std::vector<NamedLook>& fitted() const { return fitted_; }
    const std::vector<NamedLook>& drawn() const { return drawn_; }
    const NamedLook& operator[](int look) const { return fitted_[std::size_t(look)]; }
    bool holds(int look) const { return look >= 0 && look < int(fitted_.size()); }

    /// Replaces the looks, for the same scan. `drawn` holds at least one look.
    void replace(std::vector<NamedLook> drawn);
    /// Fits the looks to another scan in HU, as far as it is known, and forgets all brightnesses.
    void fitTo(const std::optional<segment::Findings>& findings);
    /// Offers looks for a scan whose values are no HU instead, and forgets all brightnesses. `spread`: its voxels.
    void fitToValues(const ValueSpread& spread);
    /// Returns whether the scan is in HU, as far as is known, so that the looks that were drawn are offered.
    bool areInHu() const { return !spread_; }

    /// Returns why a look does not suit the scan; empty if it does, or if nothing is known of the scan.
    std::string whyUnsuited(int look) const;
    /// Returns `look` if it suits the scan, else the first look that does, or `look` if none does.
    int suitedOr(int look) const;

    /// Returns the index of the look that a setup shows; -1 if it is a changed look.
    int indexOf(const ImageSetup& setup) const;
    /// Returns `setup` under the name of the look that it shows, or as a changed version of `before`, the name of the
    /// look that it was made from. An image must not bear the name of a look that it does not show.
    ImageSetup named(ImageSetup setup, const std::string& before) const;
    /// Returns the look that a setup shows or was changed from; null if there is none.
    const NamedLook* beginningOf(const ImageSetup& setup) const { return lookCalled(setup.lookName); }
    /// Returns the look named `name`; null if there is none.
    const NamedLook* lookCalled(const std::string& name) const;

    /// Returns the brightness that suits the scan under a look [stops]; 0: not known yet.
    double stops(int look) const { return stops_[std::size_t(look)].value_or(0); }
    /// Takes the brightness that suits the scan under a look [stops]. Returns false if one is known already, and for
    /// the user's own looks, whose brightness the user has chosen.
    bool suggestStops(int look, double stops);

  private:
    void fit();

    std::vector<NamedLook> drawn_;
    std::vector<NamedLook> fitted_;
    std::vector<std::optional<double>> stops_;
    std::optional<segment::Findings> findings_;
    std::optional<ValueSpread> spread_;  ///< none: the scan is in HU
};

}  // namespace pdr::app
