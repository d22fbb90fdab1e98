#pragma once
/// The desktop program: owns all of its parts and connects them.

#include <filesystem>
#include <memory>
#include <vector>

#include "app/desktop/desktop_parts.h"
#include "app/desktop/settings.h"

namespace pdr::app {

class Desktop {
  public:
    /// `looks` holds at least one look.
    /// `settingsFile`: where to save the settings, with the user's looks in a folder beside it; empty: the user's
    /// configuration.
    /// `threads`: number of CPU threads if the CPU takes over from another device; 0: one per core.
    /// `powerSupplies`: see onBattery(); empty: rendering does not depend on the power supply.
    Desktop(std::vector<NamedLook> looks, std::unique_ptr<Device> device, const QString& settingsFile = {},
            int threads = 0, std::filesystem::path powerSupplies = {});
    /// Saves the window's geometry and state for the next run.
    ~Desktop();

    DesktopParts parts() {
        return {import_,   document_, bridge_,     window_,         settings_, study_, tissue_,
                cut_,      light_,    modelTrial_, picture_,        masks_,    sky_,   looks_,
                ownLooks_, nodes_,    said_,       seriesPictures_, battery_};
    }
    ui::MainWindow& window() { return window_; }
    /// Reads a folder, or the folder of a file, and lists its series; if only one can be shown, it is shown.
    void open(const QString& path) { import_.scanFolder(ui::folderOf(QFileInfo(path))); }

  private:
    Settings settings_;
    ui::MainWindow window_;
    Document document_;
    TissueEdits tissue_{document_};
    CutEdits cut_{document_};
    LightEdits light_{document_};
    TissueStudy study_;
    RenderBridge bridge_;
    ImportJob import_;
    ModelTrial modelTrial_;
    PictureJob picture_;
    MaskJob masks_;
    SkyJob sky_;
    LookPictures looks_;
    OwnLooks ownLooks_;
    NodesJob nodes_{bridge_};
    SaidOnce said_;
    SeriesPictures seriesPictures_;
    BatteryRest battery_;
};

}  // namespace pdr::app
