// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the window costs: time to the first frame, CPU of a frame, memory after a long run.
// Start it under the display that is to be measured: bench_window [SECONDS [CIRCLES]].
#include "app/main_window.h"
#include "app/workbench.h"
#include "tasks/reading/lab_reader.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimer>
#include <QWindow>

#include <ctime>

using namespace cradle;

namespace {

double cpuSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Resident memory, MB.
double residentMb()
{
    QFile statm(QStringLiteral("/proc/self/statm"));
    if (!statm.open(QIODevice::ReadOnly))
        return 0.0;
    return statm.readAll().split(' ').value(1).toDouble() * 4096.0 / 1e6;
}

void spin(double seconds)
{
    QEventLoop loop;
    QTimer::singleShot(static_cast<int>(1000.0 * seconds), &loop, &QEventLoop::quit);
    loop.exec();
}

} // namespace

int main(int argc, char **argv)
{
    QElapsedTimer sinceStart;
    sinceStart.start();
    QApplication app(argc, argv);
    QTextStream out(stdout);
    const double seconds = argc > 1 ? QString::fromLocal8Bit(argv[1]).toDouble() : 10.0;
    const int circles = argc > 2 ? QString::fromLocal8Bit(argv[2]).toInt() : 2;

    QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
    applyTheme(ThemeChoice::Light);
    Workbench bench(folder.filePath(QStringLiteral("progress.json")));
    MainWindow window(bench, settings, ThemeChoice::Light);
    bench.openLab(QLatin1String(shippedLab), QStringLiteral("en"));
    bench.openTask(QStringLiteral("L42T17"));
    window.resize(1280, 720);
    window.show();
    while (!window.windowHandle() || !window.windowHandle()->isExposed())
        QApplication::processEvents();
    QApplication::processEvents();
    out << "first frame after " << sinceStart.elapsed() << " ms, " << 1000.0 * cpuSeconds()
        << " ms of CPU, " << residentMb() << " MB" << Qt::endl;

    Preset preset = bench.document().preset();
    preset.gravity = {0.0, -9.81};
    preset.restitution = 1.0;
    if (circles > 2) {
        preset.gravity = {};
        preset.laws.timing = Timing::Continuous;
        preset.fill = CircleFill{.count = circles, .radius = 0.05, .rmsSpeed = 2.0};
        preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    }
    bench.document().open(preset);
    Simulation &simulation = bench.simulation();
    int frames = 0;
    QObject::connect(&simulation, &Simulation::frameReady, &app, [&frames] { ++frames; });
    simulation.start();
    spin(1.0);
    frames = 0;
    const double before = cpuSeconds();
    spin(seconds);
    const double used = cpuSeconds() - before;
    out << frames << " frames in " << seconds << " s, " << 1000.0 * used / std::max(1, frames)
        << " ms of CPU each, " << residentMb() << " MB" << Qt::endl;

    simulation.pause();
    spin(1.0);
    const double idle = cpuSeconds();
    spin(3.0);
    out << "paused: " << 100.0 * (cpuSeconds() - idle) / 3.0 << " % of a core" << Qt::endl;

    // A minute, ten and an hour of the scene, as fast as it goes.
    for (const double minutes : {1.0, 10.0, 60.0}) {
        if (circles > 2)
            break;
        simulation.goTo(static_cast<qint64>(minutes * 60.0 / preset.timestep));
        spin(0.5);
        simulation.start();
        spin(0.5);
        frames = 0;
        const double start = cpuSeconds();
        spin(3.0);
        out << "after " << minutes
            << " min: " << 1000.0 * (cpuSeconds() - start) / std::max(1, frames)
            << " ms of CPU a frame, " << residentMb() << " MB" << Qt::endl;
        simulation.pause();
    }
    return 0;
}
