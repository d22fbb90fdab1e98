#pragma once
/// The desktop as a whole: its parts, put together and wired.

#include <filesystem>
#include <memory>
#include <vector>

#include "app/desktop/desktop_parts.h"
#include "app/desktop/settings.h"

namespace pdr::app {

class Desktop {
  public:
    /// `looks` holds at least one. `settingsFile`: where to keep the settings, with the
    /// user's looks beside them; empty: the user's own place.
    /// `threads`: of the CPU, when another device is left for it; 0 = one per core.
    /// `powerSupplies`: see onBattery(); empty: rendering takes no account of them.
    Desktop(std::vector<NamedLook> looks, std::unique_ptr<Device> device, const QString& settingsFile = {},
            int threads = 0, std::filesystem::path powerSupplies = {});
    /// Keeps the window's geometry for the next time.
    ~Desktop();

    DesktopParts parts() {
        return {import_,   document_, bridge_,     window_,         settings_, study_, tissue_,
                cut_,      light_,    modelTrial_, picture_,        masks_,    sky_,   looks_,
                ownLooks_, nodes_,    said_,       seriesPictures_, battery_};
    }
    ui::MainWindow& window() { return window_; }
    /// Reads a folder, or that of a file, and lists its series; where there is only one to show, it is shown.
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
