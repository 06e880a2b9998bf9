// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/stop_signal.h"

#include <csignal>

namespace cradle::cli {

namespace {

volatile std::sig_atomic_t asked = 0;

} // namespace

void watchForStop()
{
    struct sigaction action {
    };
    action.sa_handler = [](int) { asked = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND); // who waits is woken
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool stopAsked()
{
    return asked != 0;
}

} // namespace cradle::cli
