<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Checks</name>
    <message>
        <source>At step %1 circle %2 hit a wall and its velocity along the wall changed from %3 to %4 m/s; only the part into the wall should change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 turned round although its rim was still %3 m from the %4; it should touch first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 was already leaving the %3 with %4 m/s and was turned round again; it should be left alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; %6 m/s is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; −e times %4 m/s with e = %6 is %7 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the rim of circle %2 is %3 m beyond the %4; at most the way of one step, %5 m, is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 is still moving into the %3 with %4 m/s, since step %5; the wall should turn it round at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m at once; with its velocity it comes %4 m far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the circles changed their velocities although their rims were still %2 m apart; they should touch first, at a distance of r₁ + r₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the circles were already moving apart with %2 m/s and were hit again; circles that move apart should be left alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle 1 left the hit with %2 m/s and circle 2 with %3 m/s; along the line of centres %4 it should be %5 and %6 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The circles hit each other %1 times; at least %2 is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The circles never hit each other; they should</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the hit changed the total momentum from %2 to %3 kg m/s; it should stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the hit changed the kinetic energy from %2 to %3 J; it should stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 left the first hit with %3 m/s; %4 m/s is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the kinetic energy was %2 J before the hit and %3 J after it; with e below 1 it should be less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s; the circles should pass through each other unchanged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed by %3 m/s, an acceleration of %4 m/s²; %5 m/s² is right here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; by %4 it moves by %5 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; its velocity times the timestep is %4 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>. This is what %1 does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle %1 is never free of walls and other circles, so its motion cannot be judged; a start in the open is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle %1 moves by none of the four integrators under gravity %2 m/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle %1 moves by %2 and circle %3 by %4; the same for both is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m; x₀ + v₀t + ½gt² is %4 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Euler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>symplectic Euler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>velocity Verlet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After %1 s circle %2 still comes %3 m above the floor with e = %4; at most %5 m is right for its integrator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2 %4 at the start; %3 %4 is asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position of circle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The velocity of circle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The radius of circle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The density of circle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are %1 circles; %2 are asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m with %4 m/s and circle %5 at %6 m with %7 m/s; they should be in the same place with the same velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no circle %1; add one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A check runs at most %1 circles; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The timestep %1 s is too short to be judged; %2 s or more is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not judged: the program stopped with an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the check took more than %1 s and was stopped; an update should take less than a millisecond</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CircleEdits</name>
    <message>
        <source>circle %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>the check took more than %1 s and was stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Judges a program, or with --preset alone the engine&apos;s laws, for one step: by what they do. A program that does not load or that stops does not pass; why is also on standard error, as FILE:LINE: message.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the step, like L42T5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program to judge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene; without it that of the step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lab&apos;s folder; without it the shipped lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the scenes; 1 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of %1; text without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where to write; without it the terminal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exit with 0 also if it did not pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SCRIPT.lua or --preset P.json is missing: what is to be judged?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown format %1; one of %2 is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--seed %1 is not a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lab has no step %1; it has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no text in UTF-8, which would be right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs a scene, by its laws or by a program, and writes what happens: tables, or without any a summary. If the program stops, why is on standard error as FILE:LINE: message, the tables reach up to there, and the exit status is 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instead of the preset&apos;s, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>discrete, continuous or exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a program that moves the circles; what it prints goes to standard error, what it plots and draws is dropped, its hits are inferred</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write every N-th step only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>table of the circles&apos; states</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>table of momentum and energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>table of the hits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 %2 is not right; %3 is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number above 0 and at most %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--duration S is missing: how long, in s?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 steps are too many; at most %2 are right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 circles, %3 steps, %4 s, %5 hits
momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an argument is missing; see %1 --help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unexpected argument %1; see %2 --help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 steps, %2 mistakes, %3 problems, %4 s
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Judges a lab itself: starters fail by a check, solutions pass, every known mistake fails and is recognised, and every check is failed by a mistake. Prints which mistake (row) fails which check (column, x) and what it is taken for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lab&apos;s folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this step alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lab has no step %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GlPainter</name>
    <message>
        <source>No OpenGL context can be made here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed, but %1 offers %2.%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shader %1 is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shader %1 does not compile: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaders %1 do not link: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenGL has no memory for the scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HitParts</name>
    <message>
        <source>before %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n</source>
        <comment>the normal vector</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>across %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabReader</name>
    <message>
        <source>the text is not in UTF-8, which would be right; some letters are lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program begins without a comment; what the student should read of it stands there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another step has the id %1 already; an id of its own is right</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabVerifier</name>
    <message>
        <source>stops with an error at line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>passes; a starter should fail by a check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fails with seed %1 by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>passes; a mistake should fail by a check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not recognised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is taken for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fails by %1; work that gets a remark passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no solution.lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no mistake fails the check %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LuaApi</name>
    <message>
        <source>You write it: runs once, before the first step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You write it: moves the circles by one step of timestep seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new vector; its unit is that of its numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dot product of two vectors: a.x * b.x + a.y * b.y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All circles: circles[1] to circles[#circles]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The acceleration of every circle, a vector in m/s²; may be set in on_load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From 0 (no rebound) to 1 (elastic); may be set in on_load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The box that the circles are in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds since the start of the run, at the start of this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of steps made so far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a point of this step to the curve called name in the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws over the scene, for this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes a line to the console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Functions of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Functions of texts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Functions of lists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For a loop over a list in order: for i, v in ipairs(list) do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For a loop over all fields of a table: for k, v in pairs(t) do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arguments from number n on; with &apos;#&apos; how many there are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a value is, as a text: &quot;number&quot;, &quot;vector&quot;, &quot;circle&quot; …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A value as a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number that a text says, or nil; base is 10 unless given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the run with the message if value is false or nil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the run at this line with the message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calls f: true and its results, or false and the error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The length of the vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The square of the length: v:dot(v)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vector of length 1 with the same direction; an error for (0, 0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dot product with another vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vector turned left by 90°: (-y, x)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part to the right; to change it, build a new vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part upwards; to change it, build a new vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The centre, a vector in m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A vector in m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In m, above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In 1000 kg/m³, above 0: steel has 7.8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of the circle, from 1; cannot be set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the side of the box, in m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The x of the left wall, in m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The x of the right wall, in m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The y of the floor, in m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The y of the ceiling, in m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An arrow that begins at from; colour and label may be left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A line between two points; the colour may be left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A dot; the colour may be left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A text at a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x without its sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angle whose cosine is x, in radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angle whose sine is x, in radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angle of the direction (x, y), in radians; x is 1 unless given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next whole number that is not below x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cosine of an angle in radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radians in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>e to the power of x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next whole number that is not above x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left of x divided by y, with the sign of x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Infinity: more than any number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The logarithm of x; base is e unless given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest of the numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest whole number of Lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest of the numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest whole number of Lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole part of x, and the rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3.14159…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees in radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From 0 up to 1, or a whole number from m to n; the same in every run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begins another row of random numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sine of an angle in radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The square root of x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tangent of an angle in radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x as a whole number, or nil if it is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;integer&quot;, &quot;float&quot;, or nil if x is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether m is below n, both read without sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values in a text: string.format(&quot;%.3f&quot;, x)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of bytes of a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A text in small letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of a text; -1 is its last byte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A text in capital letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The elements of a list as one text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts a value into a list, at its end if no position is given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes an element out of a list, the last one unless told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sorts a list; before(a, b) says whether a comes first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The elements of a list as so many values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>open this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speak this language: en or de</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>system, light or dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>work on steps by this: explore or code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take this program as your own of the step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draw the window into this file and quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the scene&apos;s time, s, in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the window, pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no step %1; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Learn how a physics engine works by writing one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lab or the scene to open; without it Lab 4.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cradle: unexpected argument %1; one lab or scene is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cradle: --language %1: en or de is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cradle: --theme %1: system, light or dark is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cradle: --mode %1: explore or code is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--at %1: a number of seconds from 0 to %2 is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--size %1: a size like 1280x800 is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open lab…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;scene…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;move circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to the &amp;step&apos;s scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps as long as the &amp;frames took</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the original lab did: see why stable timesteps matter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Scene shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Parts of a hit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Drawings of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;whole square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Panes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Move panes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene drawn &amp;by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reference of the lab&apos;s Lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Cradle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>%1 circles of radius %2 m do not fit into the square; at most %3 are right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is out of range; a number from %2 to %3 is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name is too long; at most %1 characters are right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; one like #1e90ff is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is wider than the square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x and y from %1 to %2 m are right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle %1 at (%2, %3) m is not inside the square, whose walls reflect; %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circles %1 and %2 overlap: their centres are %3 m apart; at least r₁ + r₂ = %4 m is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 circles are right</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Progress</name>
    <message>
        <source>your progress could not be read and was moved to %1; Cradle begins anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>your progress could not be saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>in step %1, at %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commit message: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the scene: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moved there by %1:%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not pass: the program stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not pass: the program does not load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not pass: %2 of %3 checks failed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ResultPane</name>
    <message>
        <source>The program cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program takes too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program needs too much memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in step %1, at %2 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>%1 m/s</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; the keys here are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not right here; right would be %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1, the format that this version reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a circle number from 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a colour like #1e90ff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a language code like en or de</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of circle numbers from 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of circles, or an object with fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of folder names, in order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of remarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of timesteps in s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list of velocities [x, y] in m/s, one per circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list out of euler, symplectic_euler, verlet, rk4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list out of stop, swap_velocities, swap_normal, impulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number in m from -10000 to 10000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number in m/s from -1e7 to 1e7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number in m/s² from -10000 to 10000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a short name of letters, digits, dots and dashes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text of at most 200 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text of at most 2000 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from 0 to 2147483647</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object that says which scenes the check runs: kind, count, duration, timesteps and what they vary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with count and radius, and if wanted rms_speed, density, seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with format, id, title, commit, preset, hints, code_hints, remarks, checks and extra</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with format, id, title, version, language and steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with format, name, square, gravity, restitution, timestep, laws and circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with half_width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with id, compare and scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with id, kind, title, parameters and scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with position, and if wanted name, velocity, radius, density, colour, integrator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with the parameters of the kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with the texts of the mistakes by their name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with the texts of the remarks by their name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with the titles of the checks by their id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with title, hints, code_hints, checks, mistakes and remarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object with walls, circles and timing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half the side of the square in m, a number from 1e-6 to 10000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far off centre the circles meet at most, in r1 + r2, a number from 0 to 0.95</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long each runs in s, a number above 0 and at most 600</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how many circles, a whole number from 1 to 100000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how many hits there must be at least, a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how many scenes, a whole number from 1 to 200</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of discrete, continuous, exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of euler, symplectic_euler, verlet, rk4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of none, reflect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of none, stop, swap_velocities, swap_normal, impulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of own, flight, directions, corners, encounters, drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of velocities, positions, fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of stop, swap_velocities, swap_normal, impulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the coefficient of restitution e, a number from 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the density in 1000 kg/m³, a number from 1e-9 to 1e9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of a file beside task.json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of a folder beside lab.json: letters, digits, dashes and underscores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of a kind of check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radius in m, a number from 1e-6 to 10000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the root mean square speed in m/s, a number from 0 to 1e6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the timestep in s, a number from 1e-6 to 0.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>true or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two numbers [x, y]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two numbers [x, y] in m, each from -10000 to 10000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s, each from -1e7 to 1e7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s², each from -10000 to 10000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two numbers, the least and the most</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Script</name>
    <message>
        <source>%1 has no field %2; a field has a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no field `%2`: did you mean `%3`?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no field `%2`; it has %3. A field of your own must be set before it is read: %1.%2 = …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a vector, not %2; write vec(x, y)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 would be %2; every number of a circle must be finite. Look for a division by zero, or for a value that grows in every step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a number, not %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 would be %2; it must be finite and above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.index is given and cannot be changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circles[i] takes a number from 1 to %1, not %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circles cannot be added or removed by a program; set the position and velocity of those that are there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, so it has no fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, not a function that can be called</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, not a number to calculate with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; only numbers compare with numbers (the length of a vector is v:length())</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a function calls itself without end (stack overflow)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program needs more than %1 MiB of memory; is there a table or a text that grows without end?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program called error with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no text, so it is no program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parentheses, blocks or terms are nested too deeply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%p of string.format is not part of the lab&apos;s Lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1.%2` is not part of the lab&apos;s Lua; %1 has %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no `%2`; it has %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no `%2`: did you mean `%1.%3`?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pairs goes through a table or circles, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this step has run for more than %1 s; is there a loop that does not end?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this step takes more than %1 million instructions; is there a loop that does not end?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run was stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>functions call each other %1 deep; does one call itself without end?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program has %1 letters; at most %2 are right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no memory to run a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` is local here, so nobody can call it; write function %1(…) without local</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lua has no %2=; write %1 = %1 %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;not equal&quot; is ~= in Lua, not !=</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lua has no ++; write %1 = %1 + 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a comment begins with -- in Lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lua writes `and`, `or`, `not` in words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>= assigns; to compare write ==</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>== compares; to assign write =</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names have the letters a to z, digits and _ only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program shows more than %1 KiB in one step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a text, not %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name in plot(name, number)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name in plot(name, number) must have 1 to %1 letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plot(name, number) takes a number, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plot(&quot;%1&quot;, …) would be %2; a finite number is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 would draw at %2; finite numbers are right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 would end beyond all numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the text in draw.text(p, text)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draw has no `%1`; it has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draw has no `%1`: did you mean `%2`?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after on_load the scene cannot be run: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`on_update` is no function any more; it is given once: function on_update(timestep) … end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vector %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 %3 has no meaning: %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector is added to a vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector is taken from a vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector is multiplied by a number; for the dot product write a:dot(b)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector is divided by a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector has no `%1`; it has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector has no `%1`: did you mean `%2`?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector cannot be changed; build a new one: %1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` belongs to a vector; write v:%1(), with a colon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vector (0, 0) has no direction, so it cannot be normalized</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers; %1 is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs a vector, not %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no %1: the scene has %2 circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` is not known: did you mean `%2`?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` is not known: nothing of that name was given a value before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` is set once, in on_load; in on_update it can only be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gravity must be a vector in m/s², not %1; write gravity = vec(0, -9.81)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gravity would be %1 m/s²; at most %2 is right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>restitution must be a number from 0 to 1, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` can only be read; choose another name for a variable of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` is given by the lab and cannot be replaced; choose another name for a variable of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>`%1` must be a function, not %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square has no `%1`; it has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square has no `%1`: did you mean `%2`?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the square can only be read</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Variant</name>
    <message>
        <source>timestep 1/%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>throw %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle %1 towards %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drop %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact at %1°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>your program cannot be saved here: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WorldText</name>
    <message>
        <source>`%1` is not part of the lab&apos;s Lua; see the API page (F1) for what is</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ApiPage</name>
    <message>
        <source>API reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search (Return: next place in the text)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the API reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entries of the API reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not found in the reference: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ChartPane</name>
    <message>
        <source>%1 · %2</source>
        <comment>heading · unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 over time, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the last %1 seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <comment>the whole run</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ChartPlot</name>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CheckRow</name>
    <message>
        <source>Show the moment ▸</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what was observed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what was observed: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CircleTableModel</name>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre, to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre, upward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity upward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density in 1000 kg/m³; steel has 7.8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How position and velocity are carried over a timestep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of a ball of this radius and density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Euler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symplectic Euler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change position of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change radius of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change density of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change integrator of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CirclesGroup</name>
    <message>
        <source>Circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a circle at a free place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a copy of the selected circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected circle (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to the step&apos;s scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring back the scene that the step came with; Undo takes it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove circle</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CodeActions</name>
    <message>
        <source>Run code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the program as it stands now, from the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step into line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run one line of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the rest of this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start this step afresh…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back to the program that this step begins with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the program may use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual text size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide the reference solution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the reference solution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program that passes this step, beside yours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After you have passed this step, or opened all its hints</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CodeDesk</name>
    <message>
        <source>in step %1, at %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference of the lab&apos;s Lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start this step afresh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your program goes back to what this step started from. What you have written in this step is lost. Go back?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CodeEditor</name>
    <message>
        <source>Error in line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 made the first failing step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 runs next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab indents; Ctrl+Tab, or Escape and then Tab, leaves the editor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API reference on %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CodeHeader</name>
    <message>
        <source>Run as I type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run every change at once, as long as the program parses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More for the program</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CodePane</name>
    <message>
        <source>saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not parse: the last good version runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::CompletionPopup</name>
    <message>
        <source>Completions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleDelegate</name>
    <message>
        <source>load</source>
        <comment>printed while loading</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleModel</name>
    <message>
        <source>step %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed in step %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed while the program was loaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed in step %1, at %2 s; a double click shows it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleView</name>
    <message>
        <source>Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>print(…) in your program writes here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines that the program has printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::EnergyChart</name>
    <message>
        <source>By the pro&amp;gram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy made by the program besides the hits, or lost if negative: total + dissipated in hits − total at the start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the &amp;integrator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy made by the integrator, or lost if negative: total + dissipated in hits − total at the start. So start = total + dissipated − made by the integrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Run to see the energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Total</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Total of e&amp;ach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kinetic, &amp;each circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Kinetic, all circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Potential</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dissipated in hits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>potential</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kinetic %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dissipated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by the integrator</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ErrorLine</name>
    <message>
        <source>line %1, step %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program stopped: %1</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>Find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Match case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::FormulaRenderer</name>
    <message>
        <source>Cradle was built without MathJax, so formulas show as text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MathJax does not run: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::HitsModel</name>
    <message>
        <source>left wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>circle, wall</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>circle, circle</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hit %1 at %2 s: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hit %1 at %2 s, circle %6 on the %7: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum (p_x, p_y) of the circles of the hit; p_x alone where there is no p_y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>impulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These values are the start of the run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not possible: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number; 0.5, 1e-3 or 1/240 would be right.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::InstructionsPane</name>
    <message>
        <source>Hint %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hint %1 of %2 ▸</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show hint %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hints</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::LawsGroup</name>
    <message>
        <source>Change law for walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change law for circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change timing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laws</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <comment>law for walls</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles leave the square unhindered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A wall turns the part of the velocity that points into it around, and multiplies it by e.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <comment>law for circles</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles pass through each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles that meet both stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap velocities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles that meet exchange their whole velocities.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap normal parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the parts of the velocities along the line of centres are exchanged; the parts across it stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An impulse along the line of centres keeps the momentum, with the masses and the restitution e.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After each step overlaps are looked for; on a hit the circles go back to their old positions and respond.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time of a hit inside the step is found, and the rest of the step is spent after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion is solved from hit to hit; the timestep only says when to look.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::LocalsTable</name>
    <message>
        <source>Local variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None at this line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local variables at the line that runs next</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::MainWindow</name>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lab.lua</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Cradle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Learn how a physics engine works by writing one.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Built with Qt, Lua, QScintilla, MathJax and valijson.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing hits anything within the next minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source># %1

This scene belongs to no step: play with it. Choose a step above to go back to the lab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scene of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the step on the left, write your program below the scene, press Run to watch, and Check when you are done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the step on the left, set the values below the scene, press Run to watch, and Check when you are done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>so far in this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a scene of the check, at the moment where it went wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to my scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::MomentumChart</name>
    <message>
        <source>Momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Run to see the momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sum %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Got it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::PictureObjects</name>
    <message>
        <source>pictures from elsewhere are not loaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture must be in the folder of the instructions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no picture %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture refers to another file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::PlotsChart</name>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plot(name, number) in your program adds a curve here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::PresetDocument</name>
    <message>
        <source>This is a scene of the check; go back to your own scene to change it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to the step&apos;s own scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ResultPane</name>
    <message>
        <source>Checking… %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ You have passed this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Check (Ctrl+Return) when you are done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed since this check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 ▸</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show line %1 of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Passed: the check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Passed: all %1 checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That was the last step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still open: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next step ▸</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next step (Ctrl+Page Down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the reference solution beside your program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commit message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the commit message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::SceneEditor</name>
    <message>
        <source>Your program sets this circle in on_load; change it there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set velocity of %1 to zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Restart (R) to change the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
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
    <message>
        <source>ghost: %1 · %2 m apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first %1 s dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first %1 min dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a circle: Edit → Add circle (Ctrl+Shift+N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>selected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add circle here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set velocity to zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::SolutionView</name>
    <message>
        <source>Reference solution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the reference solution (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the reference solution</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::StepsList</name>
    <message>
        <source>extra</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps · %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 file of this lab could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files of this lab could not be read</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step shown. Left and Right go a step, Page Up and Page Down to the previous and the next hit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to any moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hits %1–%2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::TransportBar</name>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the start of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <comment>back</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next hit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run on to the next collision</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated time per real time ([ slower, ] faster)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps since the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ValuesModel</name>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position to the right of the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position above the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>number unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>quantity, unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All circles together</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::ValuesPane</name>
    <message>
        <source>%1 •</source>
        <comment>a tab with news</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hits %L1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No hit so far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values and hits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values of the circles at the moment shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hits; Enter shows the moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last hit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No hits yet: press Run or Next hit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::Workbench</name>
    <message>
        <source>Open a scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cradle::WorldGroup</name>
    <message>
        <source>World</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restitution e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timestep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration of every circle, to the right and upward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From 0, no rebound, to 1, elastic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up doubles it, Down halves it; 1/240 can be typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the middle of the square to a wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity to the right, m/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity upward, m/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timestep, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half width of the square, m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change restitution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change timestep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change half width</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
