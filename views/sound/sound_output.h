// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <memory>
#include <vector>

namespace cradle {

/// Plays sounds, any number at once, on a thread of its own, through the sound server of the
/// desktop (PulseAudio, or PipeWire in its place). Its library is looked for when the first sound
/// is played: linking Qt Multimedia would make every start longer.
class SoundOutput final : public QObject
{
    Q_OBJECT
public:
    explicit SoundOutput(QObject *parent = nullptr);
    /// Waits for nothing: a sound server that does not answer cannot hold up the end.
    ~SoundOutput() override;

    /// Begins to play \p samples (see tone.h) as soon as possible.
    void play(std::vector<float> samples);

signals:
    /// Once: there is no sound to be had on this machine; nothing is played from now on.
    void failed();

private:
    struct Shared;
    static void run(const std::shared_ptr<Shared> &shared);

    std::shared_ptr<Shared> m_shared; ///< with the thread, which may outlive this
};

} // namespace cradle
