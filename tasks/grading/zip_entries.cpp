// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/zip_entries.h"

#include <QList>

namespace cradle {

bool staysBelow(const QByteArray &name)
{
    if (name.isEmpty() || name.startsWith('/') || name.contains('\\'))
        return false;
    for (const QByteArray &part : name.split('/')) {
        if (part == ".." || part == ".")
            return false;
    }
    return true;
}

bool isZippedLink(zip_t *archive, zip_uint64_t index)
{
    constexpr zip_uint32_t unixLink = 0120000;
    constexpr zip_uint32_t unixKinds = 0170000;
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    return zip_file_get_external_attributes(archive, index, ZIP_FL_UNCHANGED, &system, &attributes)
               == 0
           && system == ZIP_OPSYS_UNIX && ((attributes >> 16) & unixKinds) == unixLink;
}

} // namespace cradle
