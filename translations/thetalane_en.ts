<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Instant</name>
    <message numerus="yes">
        <source>pass %1 of %2: %n contacts resolved together</source>
        <translation>
            <numerusform>pass %1 of %2: %n contact resolved</numerusform>
            <numerusform>pass %1 of %2: %n contacts resolved together</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SceneSourceText</name>
    <message numerus="yes">
        <source>%1 (and %n more)</source>
        <translation>
            <numerusform>%1 (and %n more)</numerusform>
            <numerusform>%1 (and %n more)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WorkedSteps</name>
    <message numerus="yes">
        <source>%n contacts are resolved together: their impulses are found all at once, so that each contact keeps its own law of restitution along its own line of centres, and impulses that meet on a body add up.</source>
        <translation>
            <numerusform>%n contacts are resolved together: their impulses are found all at once, so that each contact keeps its own law of restitution along its own line of centres, and impulses that meet on a body add up.</numerusform>
            <numerusform>%n contacts are resolved together: their impulses are found all at once, so that each contact keeps its own law of restitution along its own line of centres, and impulses that meet on a body add up.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>thetalane::InstantNote</name>
    <message numerus="yes">
        <source>Together with, among %n others:</source>
        <translation>
            <numerusform>Together with:</numerusform>
            <numerusform>Together with, among %n others:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>thetalane::ScrubBar</name>
    <message numerus="yes">
        <source>and %n more at the same instant, resolved together</source>
        <translation>
            <numerusform>and %n more at the same instant, resolved together</numerusform>
            <numerusform>and %n more at the same instant, resolved together</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more at the same instant, in %1 passes</source>
        <translation>
            <numerusform>and %n more at the same instant, in %1 passes</numerusform>
            <numerusform>and %n more at the same instant, in %1 passes</numerusform>
        </translation>
    </message>
</context>
</TS>
