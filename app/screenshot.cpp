// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshot.h"

#include "app/author_window.h"
#include "app/main_window.h"
#include "model/files/file_io.h"
#include "views/author/scene_tab.h"
#include "views/markdown_view.h"

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QPixmap>
#include <QTextStream>

#include <cmath>
#include <cstdio>

namespace cradle {

namespace {

/// Formulas are set by a thread of their own; a picture waits for them so long, ms.
constexpr int patience = 5000;
/// And always so long, for what comes a little later than the window, ms.
constexpr int settling = 700;
/// The longest run before a picture, s of the scene.
constexpr double longestRun = 3600.0;

bool isComplete(const QWidget &window)
{
    for (const auto *text : window.findChildren<MarkdownView *>()) {
        if (text->isVisible() && !text->isComplete())
            return false;
    }
    return true;
}

int complain(const QString &message)
{
    QTextStream(stderr) << QStringLiteral("cradle: ") << message << Qt::endl;
    return 2;
}

int grab(QWidget &window, Simulation &simulation, const QString &path, const QString &seconds,
         const QString &size)
{
    bool ok = false;
    const double at = seconds.toDouble(&ok);
    if (!ok || !(at >= 0.0 && at <= longestRun))
        return complain(QCoreApplication::translate(
                            "Main", "--at %1: a number of seconds from 0 to %2 is right")
                            .arg(seconds)
                            .arg(longestRun));
    if (!size.isEmpty()) {
        const QStringList parts = size.split(QLatin1Char('x'));
        const QSize wanted(parts.value(0).toInt(), parts.value(1).toInt());
        if (parts.size() != 2 || wanted.width() < 320 || wanted.height() < 240
            || wanted.width() > 8192 || wanted.height() > 8192)
            return complain(
                QCoreApplication::translate("Main", "--size %1: a size like 1280x800 is right")
                    .arg(size));
        window.resize(wanted);
    }
    window.show();
    simulation.goTo(static_cast<qint64>(std::llround(at / simulation.preset().timestep)));
    QElapsedTimer waited;
    waited.start();
    do {
        QApplication::processEvents(QEventLoop::AllEvents, 50);
    } while (waited.elapsed() < settling || (!isComplete(window) && waited.elapsed() < patience));
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    window.grab().save(&png, "PNG");
    const auto error = writeFile(path, png.data());
    return error ? complain(QCoreApplication::translate("Main", "%1 cannot be written: %2")
                                .arg(path, error->message))
                 : 0;
}

} // namespace

int takeScreenshot(MainWindow &window, const QString &path, const QString &seconds,
                   const QString &size)
{
    return grab(window, window.workbench().simulation(), path, seconds, size);
}

int takeScreenshot(AuthorWindow &window, const QString &path, const QString &seconds,
                   const QString &size)
{
    return grab(window, window.sceneTab().simulation(), path, seconds, size);
}

} // namespace cradle
