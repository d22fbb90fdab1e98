# pdr_precompile(TARGET [HEADER...]): the standard library, GLM, and these, are parsed once for all sources of TARGET. Sources
# include what they use all the same: clang-tidy looks at them without.
function(pdr_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <filesystem>
                            <functional> <limits> <map> <memory> <mutex> <optional> <set> <span> <sstream> <string>
                            <string_view> <utility> <variant> <vector> <glm/glm.hpp> ${ARGN})
endfunction()

# What windows are made of. All of <QtWidgets> would be parsed once as well, but each source instantiates its templates
# again, at 0.3 s.
set(PDR_WINDOW_HEADERS <future> <random> <QAction> <QApplication> <QBoxLayout> <QCheckBox> <QComboBox> <QDir> <QDoubleSpinBox>
    <QElapsedTimer> <QFileInfo> <QFormLayout> <QImage> <QLabel> <QLineEdit> <QLocale> <QMainWindow> <QMenu> <QMouseEvent>
    <QPainter> <QPointer> <QPushButton> <QScrollArea> <QSignalBlocker> <QSpinBox> <QThread> <QTimer> <QToolButton> <QToolTip>
    <QWidget>)
