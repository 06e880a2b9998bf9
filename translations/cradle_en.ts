<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>CheckKinds</name>
    <message numerus="yes">
        <source>there is no circle %1; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>there is no circle %1; the scene of the step has %n circle</numerusform>
            <numerusform>there is no circle %1; the scene of the step has %n circles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 needs %2 circles; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>%1 needs %2 circles; the scene of the step has %n circle</numerusform>
            <numerusform>%1 needs %2 circles; the scene of the step has %n circles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mistakes</source>
        <translation>
            <numerusform>%n mistake</numerusform>
            <numerusform>%n mistakes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) left out</source>
        <translation>
            <numerusform>%n file left out</numerusform>
            <numerusform>%n files left out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Findings</name>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time.</source>
        <translation>
            <numerusform>Of %1 meetings tried, %n was answered in time.</numerusform>
            <numerusform>Of %1 meetings tried, %n were answered in time.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time and along the line of centres: %2.</source>
        <translation>
            <numerusform>Of %1 meetings tried, %n was answered in time and along the line of centres: %2.</numerusform>
            <numerusform>Of %1 meetings tried, %n were answered in time and along the line of centres: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time: %2.</source>
        <translation>
            <numerusform>Of %1 meetings tried, %n was answered in time: %2.</numerusform>
            <numerusform>Of %1 meetings tried, %n were answered in time: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right.</source>
        <translation>
            <numerusform>Of %1 tries, early and late, here and there, %n came out right.</numerusform>
            <numerusform>Of %1 tries, early and late, here and there, %n came out right.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right: %2.</source>
        <translation>
            <numerusform>Of %1 tries, early and late, here and there, %n came out right: %2.</numerusform>
            <numerusform>Of %1 tries, early and late, here and there, %n came out right: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right: %2.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early: %2.</source>
        <translation>
            <numerusform>Of %1 meetings tried, %n was answered, in time or too early: %2.</numerusform>
            <numerusform>Of %1 meetings tried, %n were answered, in time or too early: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early.</source>
        <translation>
            <numerusform>Of %1 meetings tried, %n was answered, in time or too early.</numerusform>
            <numerusform>Of %1 meetings tried, %n were answered, in time or too early.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Grading</name>
    <message numerus="yes">
        <source>Checked %n time(s) while working on it.</source>
        <translation>
            <numerusform>Checked once while working on it.</numerusform>
            <numerusform>Checked %n times while working on it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message numerus="yes">
        <source>Move %n circles</source>
        <translation>
            <numerusform>Move %n circle</numerusform>
            <numerusform>Move %n circles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change velocities of %n circles</source>
        <translation>
            <numerusform>Change velocities of %n circle</numerusform>
            <numerusform>Change velocities of %n circles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Schema</name>
    <message numerus="yes">
        <source>a list of %n value(s)</source>
        <translation>
            <numerusform>a list of %n value</numerusform>
            <numerusform>a list of %n values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::ArrangementDialog</name>
    <message numerus="yes">
        <source>%n circle(s)</source>
        <translation>
            <numerusform>%n circle</numerusform>
            <numerusform>%n circles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::AuthorExports</name>
    <message numerus="yes">
        <source>Exported without %n file(s) that are yours: %1</source>
        <translation>
            <numerusform>Exported without %n file that is yours: %1</numerusform>
            <numerusform>Exported without %n files that are yours: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::FindBar</name>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n replaced</numerusform>
            <numerusform>%n replaced</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n match(es)</source>
        <translation>
            <numerusform>%n match</numerusform>
            <numerusform>%n matches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::FindPanel</name>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n place</numerusform>
            <numerusform>%n places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n file(s)</source>
        <translation>
            <numerusform>in %n file</numerusform>
            <numerusform>in %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced; Undo brings them back</source>
        <translation>
            <numerusform>%n place replaced; Undo brings it back</numerusform>
            <numerusform>%n places replaced; Undo brings them back</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::GradeDialog</name>
    <message numerus="yes">
        <source>%n of the students as they were before.</source>
        <translation>
            <numerusform>%n of the students as it was before.</numerusform>
            <numerusform>%n of the students as they were before.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::PinnedRuns</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::RunDesk</name>
    <message numerus="yes">
        <source>%n runs are pinned; remove one of them first.</source>
        <translation>
            <numerusform>%n run is pinned; remove it first.</numerusform>
            <numerusform>%n runs are pinned; remove one of them first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::SceneEditor</name>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>%n circle</numerusform>
            <numerusform>%n circles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paste %n circles</source>
        <translation>
            <numerusform>Paste %n circle</numerusform>
            <numerusform>Paste %n circles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::SceneView</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n selected</numerusform>
            <numerusform>%n selected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::ValuesEditor</name>
    <message numerus="yes">
        <source>Each student gets one of %n number(s): %1. You, and who gives no number, have the first.</source>
        <translation>
            <numerusform>Each student gets this %n number: %1.</numerusform>
            <numerusform>Each student gets one of %n numbers: %1. You, and who gives no number, have the first.</numerusform>
        </translation>
    </message>
</context>
</TS>
