// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/other_mistakes.h"

#include "views/menu.h"

namespace cradle {

class AuthorDocument;

/// The mistakes that other steps know and that students may make in the open step, too: a menu for
/// each step.
class OtherMistakesMenu final : public Menu
{
    Q_OBJECT
public:
    OtherMistakesMenu(const AuthorDocument &document, QWidget *parent);

    void fill(); ///< reads the programs of all steps, which takes a moment
    void retranslate();

signals:
    void chosen(const cradle::OtherMistake &mistake);

private:
    const AuthorDocument &m_document;
};

} // namespace cradle
