#pragma once
/// The part of the save dialog for the image's size and accuracy (as it is on the screen, or rendered anew) and its
/// annotations.

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>
#include <optional>

#include "ui/output/image_order.h"
#include "ui/widgets/stop_row.h"

namespace pdr::ui {

class ImageSizeBox : public QWidget {
    Q_OBJECT

  public:
    explicit ImageSizeBox(const ImageOffer& offer, QWidget* parent = nullptr);

    /// Returns the chosen size. None: the image as it is on the screen.
    std::optional<QSize> chosenSize() const;
    StopRule stop() const { return stop_->rule(); }
    Annotate annotate() const;
    /// Sets whether the file can be annotated; OpenEXR files cannot.
    void setAnnotatable(bool annotatable);

  private:
    void takeSize();
    void takeNumbers();
    void showCost();

    std::optional<ImageCost> cost_;
    QComboBox* sizes_;
    QSpinBox* width_;
    QSpinBox* height_;
    StopRow* stop_;
    QLabel* takes_;
    QComboBox* annotate_;
};

}  // namespace pdr::ui
