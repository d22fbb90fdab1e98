#pragma once
/// The desktop program: owns window, document, renderer and the presenters that make them work together.

#include <filesystem>
#include <memory>

#include "app/presenters/presenter.h"

namespace pdr::app {

class PlaceScenes;
class SeriesPresenter;

class Desktop {
  public:
    /// `looks` holds at least one look.
    /// `settingsFile`: where to save the settings, with the user's looks and unsaved plans in folders beside it; empty:
    /// the user's configuration. `threads`: number of CPU threads if the CPU takes over from another device; 0: one per
    /// core. `powerSupplies`: see onBattery(); empty: rendering does not depend on the power supply.
    Desktop(std::vector<NamedLook> looks, std::unique_ptr<Device> device, const QString& settingsFile = {},
            int threads = 0, std::filesystem::path powerSupplies = {});
    /// Saves the window's geometry and state for the next run.
    ~Desktop();

    ui::MainWindow& window() { return window_; }
    Workspace workspace() { return {document_, bridge_, window_, settings_}; }
    Document& document() { return document_; }
    RenderBridge& bridge() { return bridge_; }
    Settings& settings() { return settings_; }
    /// Returns the presenter of that class; there is one of each.
    template <class One>
    One& presenter() {
        for (const auto& presenter : presenters_)
            if (auto* one = dynamic_cast<One*>(presenter.get()))
                return *one;
        throw std::logic_error("no such presenter");
    }

    /// Reads a folder, a scan in one file, or the folder of any other file, and lists its series; if only one can be
    /// shown, it is shown.
    void open(const QString& path);

  private:
    void addPresenters(const QString& beside, std::filesystem::path powerSupplies);
    template <class One, class... Arguments>
    One& add(Arguments&&... arguments);
    void connectPresenters();
    void showDocument(Changes changes);
    void showFrame(const std::shared_ptr<const Frame>& frame);
    void cancelJob();

    Settings settings_;
    ui::MainWindow window_;
    Document document_;
    RenderBridge bridge_;
    std::unique_ptr<PlaceScenes> scenes_;
    std::vector<std::unique_ptr<Presenter>> presenters_;
};

}  // namespace pdr::app
