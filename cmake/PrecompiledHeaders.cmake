# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The headers of the system that most of a folder's sources read, parsed once for each folder. They
# only save time: every source still includes what it uses, as -DCRADLE_PRECOMPILE=OFF proves. Each
# list adds to the one before it, as the folders do.
option(CRADLE_PRECOMPILE "Compile with precompiled headers" ON)
# One that does not fit is not used, which costs time; it is no fault of the source.
set(CMAKE_PCH_WARN_INVALID OFF)

# What Clang precompiles names the clone's folder, so every clone compiles it anew; what GCC precompiles is 130 to
# 200 MB, which ccache would read for each source. So a fingerprint of what went into it stands beside it, and ccache
# takes that for the whole (CCACHE_PCH_EXTSUM in Compiler.cmake). The file's own path is an option of Clang's that
# ccache makes relative.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set(CMAKE_CXX_COMPILE_OPTIONS_USE_PCH -include <PCH_HEADER>)
    set(cradle_precompiled cmake_pch.hxx.pch)
else()
    set(cradle_precompiled cmake_pch.hxx.gch)
endif()

set(cradle_model_headers
    <algorithm> <array> <cmath> <cstdint> <deque> <functional> <limits> <map> <memory> <numbers>
    <numeric> <optional> <span> <tuple> <utility> <variant> <vector>
    <QByteArray> <QCoreApplication> <QJsonArray> <QJsonDocument> <QJsonObject> <QObject> <QString>
    <QStringList>)
set(cradle_tasks_headers ${cradle_model_headers}
    <chrono> <QDir> <QFile> <QFileInfo> <QLocale> <QRegularExpression> <QSaveFile> <QSet>)
set(cradle_views_headers ${cradle_tasks_headers}
    <QAction> <QComboBox> <QEvent> <QFontMetricsF> <QFormLayout> <QFrame> <QHBoxLayout>
    <QHeaderView> <QKeyEvent> <QLabel> <QLineEdit> <QListWidget> <QMenu> <QMouseEvent> <QPainter>
    <QPushButton> <QScrollArea> <QScrollBar> <QSplitter> <QTableView> <QTextBlock> <QTextCursor>
    <QTextDocument> <QTimer> <QToolButton> <QUndoStack> <QVBoxLayout> <QWidget>)
set(cradle_app_headers ${cradle_views_headers}
    <QApplication> <QDockWidget> <QMainWindow> <QMenuBar> <QMessageBox> <QSettings> <QTabWidget>)
set(cradle_test_headers <QElapsedTimer> <QSignalSpy> <QTemporaryDir> <QTest>)

# cradle_precompile(TARGET HEADER...)
function(cradle_precompile target)
    if(CRADLE_PRECOMPILE)
        target_precompile_headers(${target} PRIVATE ${ARGN})
        get_target_property(qt Qt6::Core LOCATION)
        file(TIMESTAMP "${qt}" qt_time)
        file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/${cradle_precompiled}.sum"
             "${ARGN} ${CMAKE_CXX_COMPILER_VERSION} ${Qt6_VERSION} ${qt_time}\n")
    endif()
endfunction()

# cradle_precompile_as(TARGET OTHER): with the headers of OTHER, which is compiled in the same way.
function(cradle_precompile_as target other)
    if(CRADLE_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM ${other})
    endif()
endfunction()
