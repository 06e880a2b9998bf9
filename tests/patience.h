// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

namespace cradle {

/// Tests wait for what must come as long as ctest lets them, ms: it ends what hangs (TIMEOUT in
/// tests/CMakeLists.txt), and a shorter limit fails where the machine is merely busy.
inline constexpr int patience = 3'600'000;

} // namespace cradle

// Qt's own wait 5 s.
#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(expression) QTRY_VERIFY_WITH_TIMEOUT(expression, cradle::patience)
#define QTRY_VERIFY2(expression, message)                                                          \
    QTRY_VERIFY2_WITH_TIMEOUT(expression, message, cradle::patience)
#define QTRY_COMPARE(expression, expected)                                                         \
    QTRY_COMPARE_WITH_TIMEOUT(expression, expected, cradle::patience)
