<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ar" sourcelanguage="en">
<context>
    <name>Arrangement</name>
    <message>
        <source>Rack</source>
        <translation>مثلث</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>شبكة</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>حلقة</translation>
    </message>
    <message>
        <source>%1 circles are too many: at most %2 are right</source>
        <translation>%1 دائرة عدد كبير: %2 على الأكثر هو الصواب</translation>
    </message>
    <message>
        <source>They do not fit into the square: fewer or smaller ones are right</source>
        <translation>لا تتسع لها المساحة المربعة: الصواب عدد أقل أو دوائر أصغر</translation>
    </message>
</context>
<context>
    <name>AuthorForms</name>
    <message>
        <source>An id of letters, digits, dots, dashes and underscores is right</source>
        <translation>الصواب معرّف من أحرف لاتينية وأرقام ونقاط وشرطات وشرطات سفلية</translation>
    </message>
    <message>
        <source>Points: a number from 0 to 1000 is right</source>
        <translation>النقاط: الصواب عدد من 0 إلى 1000</translation>
    </message>
</context>
<context>
    <name>AuthorMenu</name>
    <message>
        <source>&amp;Lab</source>
        <translation>المختبر (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;New lab…</source>
        <translation>مختبر جديد (&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open a folder…</source>
        <translation>فتح مجلد (&amp;O)…</translation>
    </message>
    <message>
        <source>Open lab in one &amp;file…</source>
        <translation>فتح مختبر في ملف واحد (&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>حفظ (&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>حفظ باسم (&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Export as one file…</source>
        <translation>تصدير ملفًا واحدًا (&amp;E)…</translation>
    </message>
    <message>
        <source>Export for st&amp;udents…</source>
        <translation>التصدير للطلاب (&amp;D)…</translation>
    </message>
    <message>
        <source>&amp;Properties…</source>
        <translation>خصائص (&amp;P)…</translation>
    </message>
    <message>
        <source>Open as a s&amp;tudent</source>
        <translation>فتح بصفة طالب (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>إغلاق (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>تحرير (&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>تراجع (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>إعادة (&amp;R)</translation>
    </message>
    <message>
        <source>F&amp;ind and replace in the lab…</source>
        <translation>البحث والاستبدال في المختبر (&amp;I)…</translation>
    </message>
    <message>
        <source>Insert the scene as a &amp;figure</source>
        <translation>إدراج المشهد شكلًا (&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Values of lab and step</source>
        <translation>قيم المختبر والمرحلة (&amp;V)</translation>
    </message>
    <message>
        <source>Start from the moment &amp;shown</source>
        <translation>البدء من اللحظة المعروضة (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>المرحلة (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>إضافة (&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>تكرار (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>إعادة تسمية (&amp;R)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>إزالة (&amp;M)</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>نقل إلى أعلى (&amp;U)</translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation>نقل إلى أسفل (&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Proof</source>
        <translation>البرهان (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Verify this step</source>
        <translation>تدقيق هذه المرحلة (&amp;V)</translation>
    </message>
    <message>
        <source>Verify the &amp;lab</source>
        <translation>تدقيق المختبر (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Suggest mistakes</source>
        <translation>اقتراح أخطاء (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>عرض (&amp;V)</translation>
    </message>
</context>
<context>
    <name>AuthorPanes</name>
    <message>
        <source>Scene</source>
        <translation>المشهد</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>النص</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>الفحوص</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>البرامج</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>البرهان</translation>
    </message>
    <message>
        <source>Parts of the step</source>
        <translation>أجزاء المرحلة</translation>
    </message>
</context>
<context>
    <name>ChartExport</name>
    <message>
        <source>the name ends in .%1, but this is a .%2 file; choose another name</source>
        <translation>ينتهي الاسم بـ .⁨%1⁩، لكن هذا ملف .⁨%2⁩؛ اختر اسمًا آخر</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>رسوم (*.svg)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>صور (*.png)</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>حفظ المخطط</translation>
    </message>
    <message>
        <source>Save the numbers of the chart</source>
        <translation>حفظ أرقام المخطط</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>جداول (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>نسخ الصورة (&amp;C)</translation>
    </message>
    <message>
        <source>Picture as PN&amp;G…</source>
        <translation>صورة بصيغة PNG (&amp;G)…</translation>
    </message>
    <message>
        <source>Picture as &amp;SVG…</source>
        <translation>صورة بصيغة SVG (&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Numbers as CSV…</source>
        <translation>الأرقام بصيغة CSV (&amp;N)…</translation>
    </message>
</context>
<context>
    <name>CheckKinds</name>
    <message>
        <source>Gravity</source>
        <translation>الجاذبية</translation>
    </message>
    <message>
        <source>What is right; that of the scene if left out</source>
        <translation>القيمة الصحيحة؛ وإن تُركت فقيمة المشهد</translation>
    </message>
    <message>
        <source>Circles collide</source>
        <translation>تصادم الدوائر</translation>
    </message>
    <message>
        <source>Leave out the moments at which circles may touch</source>
        <translation>استبعاد اللحظات التي قد تتلامس فيها الدوائر</translation>
    </message>
    <message>
        <source>Restitution e</source>
        <translation>معامل الارتداد e</translation>
    </message>
    <message>
        <source>Hits at least</source>
        <translation>عدد التصادمات على الأقل</translation>
    </message>
    <message>
        <source>How often walls must turn the circles round, together, in every scene</source>
        <translation>كم مرة يجب أن تردّ الجدران الدوائر، مجتمعةً، في كل مشهد</translation>
    </message>
    <message>
        <source>Visits at least</source>
        <translation>عدد الزيارات على الأقل</translation>
    </message>
    <message>
        <source>How often each circle must come to a wall</source>
        <translation>كم مرة يجب أن تبلغ كل دائرة جدارًا</translation>
    </message>
    <message>
        <source>Free at least</source>
        <translation>حرّة على الأقل</translation>
    </message>
    <message>
        <source>How long each circle must be free of walls and circles; a tenth of the duration if left out</source>
        <translation>كم يجب أن تبقى كل دائرة بعيدة عن الجدران والدوائر؛ وإن تُركت فعُشر المدة</translation>
    </message>
    <message>
        <source>How many hits there must be</source>
        <translation>كم تصادمًا يجب أن يقع</translation>
    </message>
    <message>
        <source>Integrators</source>
        <translation>طرائق التكامل</translation>
    </message>
    <message>
        <source>Any of these is right</source>
        <translation>أيٌّ منها صحيح</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>القوانين</translation>
    </message>
    <message>
        <source>Any of these is right: both stop; they swap their velocities; they swap the parts along the line of centres; the impulse of masses and e</source>
        <translation>أيٌّ منها صحيح: تتوقف الدائرتان؛ تتبادلان سرعتيهما؛ تتبادلان المركّبتين على خط المركزين؛ الدفع من الكتلتين وe</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>التفاوت المسموح</translation>
    </message>
    <message>
        <source>How far off is still right</source>
        <translation>كم يجوز أن يبلغ الفرق ويبقى صحيحًا</translation>
    </message>
    <message>
        <source>One for each of the circles; not looked at if left out</source>
        <translation>قيمة لكل دائرة؛ وإن تُركت فلا يُنظر فيها</translation>
    </message>
    <message>
        <source>Not looked at if left out</source>
        <translation>إن تُركت فلا يُنظر فيها</translation>
    </message>
    <message>
        <source>Starts with these values</source>
        <translation>يبدأ بهذه القيم</translation>
    </message>
    <message>
        <source>The values that a circle starts with</source>
        <translation>القيم التي تبدأ بها دائرة</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>الموضع</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>السرعة</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>نصف القطر</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>الكثافة</translation>
    </message>
    <message>
        <source>How many circles there are</source>
        <translation>كم عدد الدوائر</translation>
    </message>
    <message>
        <source>Moves by an integrator</source>
        <translation>يتحرك بطريقة تكامل</translation>
    </message>
    <message>
        <source>Every step far from walls is one of the named integrators under the named gravity</source>
        <translation>كل خطوة بعيدة عن الجدران هي من إحدى الطرائق المسمّاة تحت الجاذبية المسمّاة</translation>
    </message>
    <message>
        <source>Follows x₀ + v₀t + ½gt²</source>
        <translation>يتبع ⁦x₀ + v₀t + ½gt²⁩</translation>
    </message>
    <message>
        <source>Up to the first bounce it is where the formula says</source>
        <translation>حتى الارتداد الأول يكون حيث تقول الصيغة</translation>
    </message>
    <message>
        <source>Stay together</source>
        <translation>تبقيان معًا</translation>
    </message>
    <message>
        <source>Two circles are in the same place with the same velocity at every step</source>
        <translation>دائرتان في الموضع نفسه وبالسرعة نفسها عند كل خطوة</translation>
    </message>
    <message>
        <source>Use the same integrator</source>
        <translation>تستعملان طريقة التكامل نفسها</translation>
    </message>
    <message>
        <source>Two circles follow one and the same integrator, whichever it is</source>
        <translation>دائرتان تتبعان طريقة تكامل واحدة، أيًّا كانت</translation>
    </message>
    <message>
        <source>Is there at a moment</source>
        <translation>في مكانه عند لحظة</translation>
    </message>
    <message>
        <source>Positions and velocities at a moment; between two steps, on the straight line between them</source>
        <translation>المواضع والسرعات عند لحظة؛ وبين خطوتين على الخط المستقيم بينهما</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>اللحظة</translation>
    </message>
    <message>
        <source>Seconds from the start; the end if left out</source>
        <translation>ثوانٍ منذ البداية؛ وإن تُركت فالنهاية</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>المواضع</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>السرعات</translation>
    </message>
    <message>
        <source>Walls reflect with e</source>
        <translation>الجدران تعكس بمعامل e</translation>
    </message>
    <message>
        <source>At a wall v_n&apos; = −e v_n; the part along the wall stays; at the rim and in time</source>
        <translation>عند الجدار ⁦v_n&apos; = −e v_n⁩؛ وتبقى المركّبة الموازية للجدار؛ عند الحافة وفي الوقت المناسب</translation>
    </message>
    <message>
        <source>Stays inside</source>
        <translation>يبقى في الداخل</translation>
    </message>
    <message>
        <source>Never further beyond a wall than the way of one step and the tolerance</source>
        <translation>لا يتجاوز الجدار أبدًا بأكثر من مسافة خطوة واحدة والتفاوت المسموح</translation>
    </message>
    <message>
        <source>Bounces to the heights e²ⁿ h₀</source>
        <translation>يرتد إلى الارتفاعات ⁦e²ⁿ h₀⁩</translation>
    </message>
    <message>
        <source>After the n-th bounce it rises to e²ⁿ times the height it came from</source>
        <translation>بعد الارتداد رقم n يصعد إلى حاصل ضرب ⁦e²ⁿ⁩ في الارتفاع الذي جاء منه</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>الارتدادات</translation>
    </message>
    <message>
        <source>How many are looked at; those lower than the tolerance are not</source>
        <translation>كم منها يُنظر فيه؛ أما الأخفض من التفاوت المسموح فلا</translation>
    </message>
    <message>
        <source>How far off is still right, as a share of the first height</source>
        <translation>كم يجوز أن يبلغ الفرق ويبقى صحيحًا، كنسبة من الارتفاع الأول</translation>
    </message>
    <message>
        <source>Comes to rest</source>
        <translation>يصل إلى السكون</translation>
    </message>
    <message>
        <source>At the end it lies on the floor as still as its integrator allows</source>
        <translation>في النهاية يستقر على الأرضية ساكنًا بقدر ما تسمح طريقة تكامله</translation>
    </message>
    <message>
        <source>Collide by a law</source>
        <translation>تتصادمان بقانون</translation>
    </message>
    <message>
        <source>Circles 1 and 2 answer every contact, in time, by one of the named laws: stop, exchange velocities, exchange normal parts, impulse with e</source>
        <translation>تستجيب الدائرتان 1 و2 لكل تلامس، في وقته، بأحد القوانين المسمّاة: التوقف، تبادل السرعتين، تبادل المركّبتين الناظميتين، الدفع مع e</translation>
    </message>
    <message>
        <source>Hit when the gap closes</source>
        <translation>التصادم عند انغلاق الفجوة</translation>
    </message>
    <message>
        <source>Circles 1 and 2 answer every contact when their rims meet, neither earlier nor later, in whatever way</source>
        <translation>تستجيب الدائرتان 1 و2 لكل تلامس حين تلتقي حافتاهما، لا قبل ذلك ولا بعده، بأي طريقة كانت</translation>
    </message>
    <message>
        <source>Part with e times the speed</source>
        <translation>الافتراق بالسرعة مضروبةً في e</translation>
    </message>
    <message>
        <source>In every hit of circles 1 and 2 their relative speed along the line of centres becomes e times what it was</source>
        <translation>في كل تصادم للدائرتين 1 و2 تصير سرعتهما النسبية على خط المركزين ما كانت عليه مضروبًا في e</translation>
    </message>
    <message>
        <source>Keep momentum and energy</source>
        <translation>حفظ كمية الحركة والطاقة</translation>
    </message>
    <message>
        <source>Every hit of circles 1 and 2 keeps the momentum and, if asked, the kinetic energy</source>
        <translation>كل تصادم للدائرتين 1 و2 يحفظ كمية الحركة، والطاقة الحركية أيضًا إن طُلب ذلك</translation>
    </message>
    <message>
        <source>Kinetic energy, too</source>
        <translation>والطاقة الحركية أيضًا</translation>
    </message>
    <message>
        <source>Else only the momentum is looked at</source>
        <translation>وإلا فلا يُنظر إلا في كمية الحركة</translation>
    </message>
    <message>
        <source>What share may be missing</source>
        <translation>أي نسبة يجوز أن تنقص</translation>
    </message>
    <message>
        <source>Leave the first hit with</source>
        <translation>مغادرة التصادم الأول بـ</translation>
    </message>
    <message>
        <source>The velocities of circles 1 and 2 after their first hit</source>
        <translation>سرعتا الدائرتين 1 و2 بعد تصادمهما الأول</translation>
    </message>
    <message>
        <source>One for each of the two circles</source>
        <translation>قيمة لكل من الدائرتين</translation>
    </message>
    <message>
        <source>Lose energy</source>
        <translation>فقد الطاقة</translation>
    </message>
    <message>
        <source>The first hit of circles 1 and 2 takes kinetic energy</source>
        <translation>التصادم الأول للدائرتين 1 و2 يأخذ من الطاقة الحركية</translation>
    </message>
    <message>
        <source>Pass through each other</source>
        <translation>المرور إحداهما عبر الأخرى</translation>
    </message>
    <message>
        <source>Circles 1 and 2 cross without changing</source>
        <translation>تعبر الدائرتان 1 و2 دون تغيير</translation>
    </message>
    <message>
        <source>Your own, in Lua</source>
        <translation>فحص خاص بك، بلغة Lua</translation>
    </message>
    <message>
        <source>The function check(run) of a file looks at the whole run and says what is wrong with it</source>
        <translation>الدالة ⁦check(run)⁩ في ملف تنظر إلى التشغيل كله وتقول ما الخطأ فيه</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ملف</translation>
    </message>
    <message>
        <source>In the folder checks of the step, such as heights.lua</source>
        <translation>في المجلد checks للمرحلة، مثل ⁦heights.lua⁩</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>عدد صحيح</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>عدد</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> بوحدة ⁨%1⁩</translation>
    </message>
    <message>
        <source> from %1 to %2</source>
        <translation> من ⁨%1⁩ إلى ⁨%2⁩</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>‏true أو false</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>واحد من ⁨%1⁩</translation>
    </message>
    <message>
        <source>a list out of %1</source>
        <translation>قائمة من ⁨%1⁩</translation>
    </message>
    <message>
        <source>a list [x, y], each %1</source>
        <translation>قائمة ⁦[x, y]⁩، كلٌّ منهما ⁨%1⁩</translation>
    </message>
    <message>
        <source>a list of lists [x, y], each %1</source>
        <translation>قائمة من قوائم ⁦[x, y]⁩، كلٌّ منهما ⁨%1⁩</translation>
    </message>
    <message>
        <source>a list [least, most], each %1</source>
        <translation>قائمة ⁦[least, most]⁩، كلٌّ منهما ⁨%1⁩</translation>
    </message>
    <message>
        <source>a list, each %1</source>
        <translation>قائمة، كل عنصر فيها ⁨%1⁩</translation>
    </message>
    <message>
        <source>the name of a file in the folder checks, such as heights.lua</source>
        <translation>اسم ملف في المجلد checks، مثل ⁦heights.lua⁩</translation>
    </message>
    <message>
        <source>the moment %1 s is after the end of the scene; at most its duration of %2 s is right</source>
        <translation>اللحظة ⁦%1 s⁩ بعد نهاية المشهد؛ الصواب مدته على الأكثر، أي ⁦%2 s⁩</translation>
    </message>
    <message numerus="yes">
        <source>there is no circle %1; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>لا توجد دائرة ⁨%1⁩؛ لا دوائر في مشهد المرحلة</numerusform>
            <numerusform>لا توجد دائرة ⁨%1⁩؛ في مشهد المرحلة دائرة واحدة</numerusform>
            <numerusform>لا توجد دائرة ⁨%1⁩؛ في مشهد المرحلة دائرتان</numerusform>
            <numerusform>لا توجد دائرة ⁨%1⁩؛ في مشهد المرحلة %n دوائر</numerusform>
            <numerusform>لا توجد دائرة ⁨%1⁩؛ في مشهد المرحلة %n دائرة</numerusform>
            <numerusform>لا توجد دائرة ⁨%1⁩؛ في مشهد المرحلة %n دائرة</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not right here; right would be one of %2</source>
        <translation>⁨%1⁩ ليس صوابًا هنا؛ الصواب واحد من ⁨%2⁩</translation>
    </message>
    <message numerus="yes">
        <source>%1 needs %2 circles; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>يحتاج ⁨%1⁩ إلى ⁨%2⁩ من الدوائر؛ لا دوائر في مشهد المرحلة</numerusform>
            <numerusform>يحتاج ⁨%1⁩ إلى ⁨%2⁩ من الدوائر؛ في مشهد المرحلة دائرة واحدة</numerusform>
            <numerusform>يحتاج ⁨%1⁩ إلى ⁨%2⁩ من الدوائر؛ في مشهد المرحلة دائرتان</numerusform>
            <numerusform>يحتاج ⁨%1⁩ إلى ⁨%2⁩ من الدوائر؛ في مشهد المرحلة %n دوائر</numerusform>
            <numerusform>يحتاج ⁨%1⁩ إلى ⁨%2⁩ من الدوائر؛ في مشهد المرحلة %n دائرة</numerusform>
            <numerusform>يحتاج ⁨%1⁩ إلى ⁨%2⁩ من الدوائر؛ في مشهد المرحلة %n دائرة</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing; right would be %2</source>
        <translation>&quot;⁨%1⁩&quot; ناقص؛ الصواب ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 has no parameters</source>
        <translation>ليس لـ ⁨%1⁩ معاملات</translation>
    </message>
    <message>
        <source>%1 has no parameter &quot;%2&quot;; it has %3</source>
        <translation>ليس لـ ⁨%1⁩ المعامل &quot;⁨%2⁩&quot;؛ له ⁨%3⁩</translation>
    </message>
    <message>
        <source>%1 is not right here; right would be %2</source>
        <translation>⁨%1⁩ ليس صوابًا هنا؛ الصواب ⁨%2⁩</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>المدة</translation>
    </message>
    <message>
        <source>How long every scene runs</source>
        <translation>كم يستمر كل مشهد</translation>
    </message>
    <message>
        <source>Timesteps</source>
        <translation>الخطوات الزمنية</translation>
    </message>
    <message>
        <source>The scenes take turns with these; 1/60 s if left out, in the student&apos;s own scene its own</source>
        <translation>تتناوب المشاهد عليها؛ وإن تُركت فهي ⁦1/60 s⁩، وفي مشهد الطالب نفسه خطوته هو</translation>
    </message>
    <message>
        <source>Drawn between the least and the most</source>
        <translation>تُختار عشوائيًّا بين الأدنى والأقصى</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>مقادير السرعات</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>الزوايا</translation>
    </message>
    <message>
        <source>From the x axis; the scenes divide them evenly</source>
        <translation>من المحور x؛ تقسمها المشاهد بالتساوي</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>المشاهد</translation>
    </message>
    <message>
        <source>How many scenes are drawn</source>
        <translation>كم مشهدًا يُختار عشوائيًّا</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>أنصاف الأقطار</translation>
    </message>
    <message>
        <source>Densities</source>
        <translation>الكثافات</translation>
    </message>
    <message>
        <source>None if left out</source>
        <translation>لا شيء إن تُركت</translation>
    </message>
    <message>
        <source>Restitutions e</source>
        <translation>معاملات الارتداد e</translation>
    </message>
    <message>
        <source>The scenes take turns with these</source>
        <translation>تتناوب المشاهد عليها</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>البذرة</translation>
    </message>
    <message>
        <source>The same scenes in every check; drawn anew with the seed of the check if left out</source>
        <translation>المشاهد نفسها في كل فحص؛ وإن تُركت فتُختار من جديد ببذرة الفحص</translation>
    </message>
    <message>
        <source>The student&apos;s own scene</source>
        <translation>مشهد الطالب نفسه</translation>
    </message>
    <message>
        <source>With each of the timesteps</source>
        <translation>بكل واحدة من الخطوات الزمنية</translation>
    </message>
    <message>
        <source>Throws</source>
        <translation>رميات</translation>
    </message>
    <message>
        <source>The circles thrown together from the middle, in any direction</source>
        <translation>الدوائر مرمية معًا من الوسط، في أي اتجاه</translation>
    </message>
    <message>
        <source>Shots in all directions</source>
        <translation>قذفات في كل الاتجاهات</translation>
    </message>
    <message>
        <source>Each of the circles at the walls, all round, while the others move on where nothing meets them</source>
        <translation>كل دائرة نحو الجدران من كل جهة، بينما تمضي الأخريات حيث لا يلاقيها شيء</translation>
    </message>
    <message>
        <source>Shots at the corners</source>
        <translation>قذفات نحو الأركان</translation>
    </message>
    <message>
        <source>Each of the circles straight at the corners and just beside them, while the others move on where nothing meets them</source>
        <translation>كل دائرة نحو الأركان مباشرة وإلى جانبها تمامًا، بينما تمضي الأخريات حيث لا يلاقيها شيء</translation>
    </message>
    <message>
        <source>Encounters</source>
        <translation>لقاءات</translation>
    </message>
    <message>
        <source>Circles 1 and 2 thrown so that they meet, from all angles</source>
        <translation>الدائرتان 1 و2 مرميتان لتلتقيا، من كل الزوايا</translation>
    </message>
    <message>
        <source>Off centre</source>
        <translation>الحيد عن المركز</translation>
    </message>
    <message>
        <source>How far off centre they meet at most, in r₁ + r₂</source>
        <translation>إلى أي حد يحيد لقاؤهما عن المركز على الأكثر، بوحدة ⁦r₁&#xa0;+&#xa0;r₂⁩</translation>
    </message>
    <message>
        <source>Both move</source>
        <translation>كلتاهما تتحرك</translation>
    </message>
    <message>
        <source>Also one after the other, or one of them at rest; else circle 2 rests before the hit</source>
        <translation>وكذلك إحداهما خلف الأخرى، أو إحداهما ساكنة؛ وإلا فالدائرة 2 ساكنة قبل التصادم</translation>
    </message>
    <message>
        <source>Circles that part</source>
        <translation>دائرتان تفترقان</translation>
    </message>
    <message>
        <source>Circles 1 and 2 overlap, as after a hit that was told late, and move apart already; ask for 0 hits</source>
        <translation>الدائرتان 1 و2 متداخلتان، كما بعد تصادم أُبلغ عنه متأخرًا، وهما تتباعدان بالفعل؛ اطلب 0 تصادمات</translation>
    </message>
    <message>
        <source>Slow hits</source>
        <translation>تصادمات بطيئة</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>إسقاطات</translation>
    </message>
    <message>
        <source>Sideways</source>
        <translation>جانبيًّا</translation>
    </message>
    <message>
        <source>Speed to the right, drawn between the least and the most</source>
        <translation>السرعة نحو اليمين، تُختار عشوائيًّا بين الأدنى والأقصى</translation>
    </message>
    <message>
        <source>Again at once</source>
        <translation>مرة أخرى فورًا</translation>
    </message>
    <message>
        <source>another check has the id %1 already; an id of its own is right</source>
        <translation>لفحص آخر المعرّف ⁨%1⁩ بالفعل؛ الصواب معرّف خاص به</translation>
    </message>
    <message>
        <source>Some, between equal circles, are in front of a wall that sends circle 2 back to a second hit, with another line of centres; in two more the heavier circle meets the other twice on one line, which a wall sends back</source>
        <translation>بعضها، بين دائرتين متساويتين، يقع أمام جدار يعيد الدائرة 2 إلى تصادم ثانٍ على خط مركزين آخر؛ وفي مشهدين آخرين تلتقي الدائرة الأثقل بالأخرى، التي يعيدها جدار، مرتين على خط واحد</translation>
    </message>
    <message>
        <source>The circles come slowly to the floor and to the ceiling, sooner or later in a step: what leaves a wall more slowly than it came is easily turned twice. Some are let go at rest, just above the floor</source>
        <translation>تأتي الدوائر ببطء إلى الأرضية والسقف، في وقت مبكر أو متأخر من الخطوة: ما يغادر جدارًا أبطأ مما جاء قد يُردّ مرتين بسهولة. وبعضها يُترك من السكون فوق الأرضية مباشرة</translation>
    </message>
    <message>
        <source>The circles fall onto the floor; in the last scene, where e is 1, from so low that they bounce often</source>
        <translation>تسقط الدوائر على الأرضية؛ وفي المشهد الأخير، حيث e يساوي 1، من ارتفاع صغير فترتد كثيرًا</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>There is no circle %1; add one</source>
        <translation>لا توجد دائرة ⁨%1⁩؛ أضف واحدة</translation>
    </message>
    <message>
        <source>A check runs at most %1 circles; there are %2</source>
        <translation>يشغّل الفحص ⁨%1⁩ دائرة على الأكثر؛ وهنا ⁨%2⁩</translation>
    </message>
    <message>
        <source>The timestep %1 s is too short to be judged; %2 s or more is right</source>
        <translation>الخطوة الزمنية ⁦%1 s⁩ أقصر من أن يُحكم عليها؛ الصواب ⁦%2 s⁩ أو أكثر</translation>
    </message>
    <message>
        <source>After bounce %1 circle %2 rises to %3 m above the floor; e to the power of %4 times the first height, with e = %5, is %6 m</source>
        <translation>بعد الارتداد ⁨%1⁩ تصعد الدائرة ⁨%2⁩ إلى ⁦%3 m⁩ فوق الأرضية؛ وe أُسّ ⁨%4⁩ مضروبًا في الارتفاع الأول، مع ⁦e = %5⁩، هو ⁦%6 m⁩</translation>
    </message>
    <message>
        <source>Circle %1 comes off the floor and down again %2 times; at least %3 is right</source>
        <translation>عدد مرات ارتفاع الدائرة ⁨%1⁩ عن الأرضية ثم رجوعها إليها: ⁨%2⁩؛ الصواب ⁨%3⁩ على الأقل</translation>
    </message>
    <message>
        <source>At step %1 circle %2 hit a wall and its velocity along the wall changed from %3 to %4 m/s; only the part into the wall should change</source>
        <translation>في الخطوة ⁨%1⁩ صدمت الدائرة ⁨%2⁩ جدارًا وتغيرت سرعتها الموازية للجدار من ⁨%3⁩ إلى ⁦%4 m/s⁩؛ يجب ألا تتغير إلا المركّبة المتجهة إلى الجدار</translation>
    </message>
    <message>
        <source>At step %1 circle %2 turned round although its rim was still %3 m from the %4; it should touch first</source>
        <translation>في الخطوة ⁨%1⁩ ارتدت الدائرة ⁨%2⁩ مع أن حافتها كانت لا تزال على بعد ⁦%3 m⁩ من ⁨%4⁩؛ يجب أن تلامس أولًا</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was already leaving the %3 with %4 m/s and was turned round again; it should be left alone</source>
        <translation>في الخطوة ⁨%1⁩ كانت الدائرة ⁨%2⁩ تغادر ⁨%3⁩ بالفعل بسرعة ⁦%4 m/s⁩ ثم رُدّت مرة أخرى؛ يجب أن تُترك وشأنها</translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; %6 m/s is right</source>
        <translation>في الخطوة ⁨%1⁩ جاءت الدائرة ⁨%2⁩ إلى ⁨%3⁩ بسرعة ⁦%4 m/s⁩ وغادرته بسرعة ⁦%5 m/s⁩؛ الصواب ⁦%6 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; −e times %4 m/s with e = %6 is %7 m/s</source>
        <translation>في الخطوة ⁨%1⁩ جاءت الدائرة ⁨%2⁩ إلى ⁨%3⁩ بسرعة ⁦%4 m/s⁩ وغادرته بسرعة ⁦%5 m/s⁩؛ وحاصل ضرب ⁦−e⁩ في ⁦%4 m/s⁩ مع ⁦e = %6⁩ هو ⁦%7 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 the rim of circle %2 is %3 m beyond the %4; at most the way of one step, %5 m, is right</source>
        <translation>في الخطوة ⁨%1⁩ حافة الدائرة ⁨%2⁩ على بعد ⁦%3 m⁩ وراء ⁨%4⁩؛ الصواب مسافة خطوة واحدة على الأكثر، أي ⁦%5 m⁩</translation>
    </message>
    <message>
        <source>In %1 s circle %2 came to a wall %3 times; at least %4 must be seen to judge whether it stays inside</source>
        <translation>خلال ⁦%1 s⁩ كان عدد المرات التي جاءت فيها الدائرة ⁨%2⁩ إلى جدار ⁨%3⁩؛ يجب أن يُرى ⁨%4⁩ على الأقل للحكم على بقائها في الداخل</translation>
    </message>
    <message>
        <source>At step %1 the circles met with %2 m/s along the line of centres and parted with %3 m/s; e times as much, with e = %4, is %5 m/s</source>
        <translation>في الخطوة ⁨%1⁩ التقت الدائرتان بسرعة ⁦%2 m/s⁩ على خط المركزين وافترقتا بسرعة ⁦%3 m/s⁩؛ وحاصل ضربها في e، مع ⁦e = %4⁩، هو ⁦%5 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>في الخطوة ⁨%1⁩ تداخلت الدائرتان ومضتا كأن شيئًا لم يكن؛ يجب أن تستجيبا حالما تبلغ المسافة بينهما ⁦r₁&#xa0;+&#xa0;r₂⁩</translation>
    </message>
    <message>
        <source>At step %1 the hit changed the total momentum from %2 to %3 kg m/s; it should stay</source>
        <translation>في الخطوة ⁨%1⁩ غيّر التصادم كمية الحركة الكلية من ⁨%2⁩ إلى ⁦%3 kg m/s⁩؛ يجب أن تبقى</translation>
    </message>
    <message>
        <source>At step %1 the hit changed the kinetic energy from %2 to %3 J; it should stay</source>
        <translation>في الخطوة ⁨%1⁩ غيّر التصادم الطاقة الحركية من ⁨%2⁩ إلى ⁦%3 J⁩؛ يجب أن تبقى</translation>
    </message>
    <message>
        <source>At step %1 circle %2 left the first hit with %3 m/s; %4 m/s is right</source>
        <translation>في الخطوة ⁨%1⁩ غادرت الدائرة ⁨%2⁩ التصادم الأول بسرعة ⁦%3 m/s⁩؛ الصواب ⁦%4 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 the kinetic energy was %2 J before the hit and %3 J after it; with e below 1 it should be less</source>
        <translation>في الخطوة ⁨%1⁩ كانت الطاقة الحركية ⁦%2 J⁩ قبل التصادم و⁦%3 J⁩ بعده؛ مع e أقل من 1 يجب أن تنقص</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s; the circles should pass through each other unchanged</source>
        <translation>في الخطوة ⁨%1⁩ تغيرت سرعة الدائرة ⁨%2⁩ من ⁨%3⁩ إلى ⁦%4 m/s⁩؛ يجب أن تمر الدائرتان إحداهما عبر الأخرى دون تغيير</translation>
    </message>
    <message>
        <source>At %1 s circle %2 is at %3 m; %4 m is right</source>
        <translation>عند ⁦%1 s⁩ الدائرة ⁨%2⁩ في ⁦%3 m⁩؛ الصواب ⁦%4 m⁩</translation>
    </message>
    <message>
        <source>At %1 s circle %2 moves with %3 m/s; %4 m/s is right</source>
        <translation>عند ⁦%1 s⁩ تتحرك الدائرة ⁨%2⁩ بسرعة ⁦%3 m/s⁩؛ الصواب ⁦%4 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed by %3 m/s, an acceleration of %4 m/s²; %5 m/s² is right here</source>
        <translation>في الخطوة ⁨%1⁩ تغيرت سرعة الدائرة ⁨%2⁩ بمقدار ⁦%3 m/s⁩، أي بتسارع ⁦%4 m/s²⁩؛ الصواب هنا ⁦%5 m/s²⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; by %4 it moves by %5 m</source>
        <translation>في الخطوة ⁨%1⁩ تحركت الدائرة ⁨%2⁩ بمقدار ⁦%3 m⁩؛ وبطريقة ⁨%4⁩ تتحرك بمقدار ⁦%5 m⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; its velocity times the timestep is %4 m</source>
        <translation>في الخطوة ⁨%1⁩ تحركت الدائرة ⁨%2⁩ بمقدار ⁦%3 m⁩؛ وسرعتها مضروبةً في الخطوة الزمنية ⁦%4 m⁩</translation>
    </message>
    <message>
        <source>Circle %1 was free of walls and other circles for %2 s only; at least %3 s must be seen to judge its motion</source>
        <translation>لم تكن الدائرة ⁨%1⁩ بعيدة عن الجدران وعن الدوائر الأخرى إلا مدة ⁦%2 s⁩؛ يجب أن يُرى ⁦%3 s⁩ على الأقل للحكم على حركتها</translation>
    </message>
    <message>
        <source> or </source>
        <translation> أو </translation>
    </message>
    <message>
        <source>Circle %1 moves by %2 and circle %3 by %4; the same for both is right</source>
        <translation>تتحرك الدائرة ⁨%1⁩ بطريقة ⁨%2⁩ والدائرة ⁨%3⁩ بطريقة ⁨%4⁩؛ الصواب الطريقة نفسها لكلتيهما</translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m; x₀ + v₀t + ½gt² is %4 m</source>
        <translation>في الخطوة ⁨%1⁩ الدائرة ⁨%2⁩ في ⁦%3 m⁩؛ و⁦x₀ + v₀t + ½gt²⁩ هو ⁦%4 m⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m at once; with its velocity it comes %4 m far</source>
        <translation>في الخطوة ⁨%1⁩ تحركت الدائرة ⁨%2⁩ بمقدار ⁦%3 m⁩ دفعة واحدة؛ وبسرعتها تقطع ⁦%4 m⁩</translation>
    </message>
    <message>
        <source>left wall</source>
        <translation>الجدار الأيسر</translation>
    </message>
    <message>
        <source>right wall</source>
        <translation>الجدار الأيمن</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>الأرضية</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>السقف</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>أويلر</translation>
    </message>
    <message>
        <source>symplectic Euler</source>
        <translation>أويلر التماثلية</translation>
    </message>
    <message>
        <source>velocity Verlet</source>
        <translation>فيرليه للسرعة</translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation>رونغه-كوتا 4</translation>
    </message>
    <message>
        <source>%1: the check itself stopped, so it says nothing of your work: %2</source>
        <translation>⁨%1⁩: توقف الفحص نفسه، فهو لا يقول شيئًا عن عملك: ⁨%2⁩</translation>
    </message>
    <message>
        <source>After %1 s circle %2 still comes %3 m above the floor with e = %4; at most %5 m is right for its integrator</source>
        <translation>بعد ⁦%1 s⁩ لا تزال الدائرة ⁨%2⁩ تعلو ⁦%3 m⁩ فوق الأرضية مع ⁦e = %4⁩؛ الصواب ⁦%5 m⁩ على الأكثر لطريقة تكاملها</translation>
    </message>
    <message>
        <source>%1 is %2 %4 at the start; %3 %4 is asked for</source>
        <translation>⁨%1⁩ في البداية ⁦%2 %4⁩؛ والمطلوب ⁦%3 %4⁩</translation>
    </message>
    <message>
        <source>The position of circle %1</source>
        <translation>موضع الدائرة ⁨%1⁩</translation>
    </message>
    <message>
        <source>The velocity of circle %1</source>
        <translation>سرعة الدائرة ⁨%1⁩</translation>
    </message>
    <message>
        <source>The radius of circle %1</source>
        <translation>نصف قطر الدائرة ⁨%1⁩</translation>
    </message>
    <message>
        <source>The density of circle %1</source>
        <translation>كثافة الدائرة ⁨%1⁩</translation>
    </message>
    <message>
        <source>There are %1 circles; %2 are asked for</source>
        <translation>عدد الدوائر ⁨%1⁩؛ والمطلوب ⁨%2⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m with %4 m/s and circle %5 at %6 m with %7 m/s; they should be in the same place with the same velocity</source>
        <translation>في الخطوة ⁨%1⁩ الدائرة ⁨%2⁩ في ⁦%3 m⁩ بسرعة ⁦%4 m/s⁩ والدائرة ⁨%5⁩ في ⁦%6 m⁩ بسرعة ⁦%7 m/s⁩؛ يجب أن تكونا في الموضع نفسه وبالسرعة نفسها</translation>
    </message>
    <message>
        <source>Circle %1 came %2 m far in %3 s; at least its diameter of %4 m must be seen to judge whether they stay together</source>
        <translation>قطعت الدائرة ⁨%1⁩ مسافة ⁦%2 m⁩ في ⁦%3 s⁩؛ يجب أن يُرى قطرها ⁦%4 m⁩ على الأقل للحكم على بقائهما معًا</translation>
    </message>
    <message>
        <source>not judged: your program does not move the circles</source>
        <translation>لم يُحكم عليه: برنامجك لا يحرّك الدوائر</translation>
    </message>
    <message>
        <source>not judged: what moves the circles is not what the step asks for</source>
        <translation>لم يُحكم عليه: ما يحرّك الدوائر ليس ما تطلبه المرحلة</translation>
    </message>
    <message>
        <source>not judged: the program stopped with an error</source>
        <translation>لم يُحكم عليه: توقف البرنامج بخطأ</translation>
    </message>
    <message>
        <source>Your program moves the circles</source>
        <translation>برنامجك هو الذي يحرّك الدوائر</translation>
    </message>
    <message>
        <source>The laws of the scene move the circles</source>
        <translation>قوانين المشهد هي التي تحرّك الدوائر</translation>
    </message>
    <message>
        <source>Your program moves the circles: leave on_update out, and the laws of the scene do it</source>
        <translation>برنامجك هو الذي يحرّك الدوائر: احذف on_update، فتحرّكها قوانين المشهد</translation>
    </message>
    <message>
        <source>What the step fixes is as the step has it</source>
        <translation>ما تثبّته المرحلة باقٍ كما هو فيها</translation>
    </message>
    <message>
        <source>the check took more than %1 million instructions; an update should take a few thousand</source>
        <translation>استغرق الفحص أكثر من ⁨%1⁩ مليون تعليمة؛ ينبغي أن يستغرق التحديث بضعة آلاف</translation>
    </message>
    <message>
        <source>stopped by the machine: the check took more than %1 s. This is no verdict on the program</source>
        <translation>أوقفه الجهاز: استغرق الفحص أكثر من ⁦%1 s⁩. ليس هذا حكمًا على البرنامج</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 into the %3 was %4 m/s before the step and %5 m/s after it; with e = %6 and gravity, %7 to %8 m/s is right</source>
        <translation>في الخطوة ⁨%1⁩ كانت سرعة الدائرة ⁨%2⁩ نحو ⁨%3⁩ قبل الخطوة ⁦%4 m/s⁩ وبعدها ⁦%5 m/s⁩؛ ومع ⁦e = %6⁩ والجاذبية الصواب من ⁨%7⁩ إلى ⁦%8 m/s⁩</translation>
    </message>
    <message>
        <source>Hits that the circles answered: %1; at least %2 is right</source>
        <translation>التصادمات التي استجابت لها الدائرتان: ⁨%1⁩؛ الصواب ⁨%2⁩ على الأقل</translation>
    </message>
    <message>
        <source>Turns at walls, away from the other circle, in %1 s: %2; at least %3 must be seen to judge them</source>
        <translation>الارتدادات عن الجدران بعيدًا عن الدائرة الأخرى خلال ⁦%1 s⁩: ⁨%2⁩؛ يجب أن يُرى منها ⁨%3⁩ على الأقل للحكم عليها</translation>
    </message>
    <message>
        <source>Turns at walls in %1 s: %2; at least %3 must be seen to judge them</source>
        <translation>الارتدادات عن الجدران خلال ⁦%1 s⁩: ⁨%2⁩؛ يجب أن يُرى منها ⁨%3⁩ على الأقل للحكم عليها</translation>
    </message>
    <message>
        <source>At step %1 the rim of circle %2 is %3 m beyond the %4, where it was without any speed; it should not be beyond it</source>
        <translation>في الخطوة ⁨%1⁩ حافة الدائرة ⁨%2⁩ على بعد ⁦%3 m⁩ وراء ⁨%4⁩ حيث لم تبقَ لها سرعة؛ ينبغي ألا تكون وراءه</translation>
    </message>
    <message>
        <source>At step %1, at a wall, circle %2 had %3 m/s along the wall before the step and %4 m/s after it; with gravity alone it is %5 m/s</source>
        <translation>في الخطوة ⁨%1⁩ عند جدار كان للدائرة ⁨%2⁩ على امتداد الجدار ⁦%3 m/s⁩ قبل الخطوة و⁦%4 m/s⁩ بعدها؛ وبالجاذبية وحدها تكون ⁦%5 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was leaving the %3, with %4 m/s before the step and %5 m/s after it; with gravity alone it is %6 m/s</source>
        <translation>في الخطوة ⁨%1⁩ كانت الدائرة ⁨%2⁩ تغادر ⁨%3⁩ بسرعة ⁦%4 m/s⁩ قبل الخطوة و⁦%5 m/s⁩ بعدها؛ وبالجاذبية وحدها تكون ⁦%6 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 the circles were already moving apart with %2 m/s, and their velocities changed from %3 and %4 to %5 and %6 m/s; circles that move apart should be left alone</source>
        <translation>في الخطوة ⁨%1⁩ كانت الدائرتان تتباعدان بالفعل بسرعة ⁦%2 m/s⁩، وتغيّرت سرعتاهما من ⁦%3⁩ و⁦%4⁩ إلى ⁦%5⁩ و⁦%6 m/s⁩؛ الدائرتان المتباعدتان يجب أن تُتركا وشأنهما</translation>
    </message>
    <message>
        <source>At step %1, with e = %2, the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>في الخطوة ⁨%1⁩، مع ⁦e = %2⁩، تداخلت الدائرتان ومضتا كأن شيئًا لم يكن؛ يجب أن تستجيبا حالما تبلغ المسافة بينهما ⁦r₁&#xa0;+&#xa0;r₂⁩</translation>
    </message>
    <message>
        <source>In this scene no velocity changed in a hit of the circles, so there is none to judge</source>
        <translation>في هذا المشهد لم تتغيّر أي سرعة في أي تصادم بين الدائرتين، فلا تصادم يمكن الحكم عليه</translation>
    </message>
    <message>
        <source>In this scene no hit changed the velocities of the circles; one should</source>
        <translation>في هذا المشهد لم يغيّر أي تصادم سرعتي الدائرتين؛ ويجب أن يحدث ذلك</translation>
    </message>
    <message>
        <source>. In this step %1 does so</source>
        <translation>. في هذه الخطوة تفعل ذلك طريقة ⁨%1⁩</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s although it touched neither a wall nor the other circle, from whose rim it was still %5 m away</source>
        <translation>في الخطوة ⁨%1⁩ تغيّرت سرعة الدائرة ⁨%2⁩ من ⁦%3⁩ إلى ⁦%4 m/s⁩ مع أنها لم تلامس جدارًا ولا الدائرة الأخرى التي كانت حافتها لا تزال على بعد ⁦%5 m⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m, as by no integrator that this check allows; the nearest of them, %4, moves it by %5 m</source>
        <translation>في الخطوة ⁨%1⁩ تحركت الدائرة ⁨%2⁩ بمقدار ⁦%3 m⁩، ولا تفعل ذلك أي طريقة يقبلها هذا الفحص؛ وأقربها، ⁨%4⁩، تحركها بمقدار ⁦%5 m⁩</translation>
    </message>
    <message>
        <source>At step %1 circle %2 still has %4 m/s into the %3, as it has since step %5; the wall should turn it round at once</source>
        <translation>في الخطوة ⁨%1⁩ لا تزال للدائرة ⁨%2⁩ سرعة ⁦%4 m/s⁩ نحو ⁨%3⁩ كما هي منذ الخطوة ⁨%5⁩؛ يجب أن يردّها الجدار فورًا</translation>
    </message>
    <message>
        <source>At step %1 circle %2 still has %4 m/s into the %3, as it has since step %5; with e = %6 the wall should answer at once</source>
        <translation>في الخطوة ⁨%1⁩ لا تزال للدائرة ⁨%2⁩ سرعة ⁦%4 m/s⁩ نحو ⁨%3⁩ كما هي منذ الخطوة ⁨%5⁩؛ ومع ⁦e = %6⁩ يجب أن يستجيب الجدار فورًا</translation>
    </message>
    <message>
        <source>In this scene the circles never met, so nothing shows whether they pass through each other</source>
        <translation>في هذا المشهد لم تلتقِ الدائرتان قط، فلا شيء يبيّن هل تمر كل منهما عبر الأخرى</translation>
    </message>
    <message>
        <source>At step %1, where the circles do not touch, the total momentum changed from %2 to %3 kg m/s; it should stay</source>
        <translation>في الخطوة ⁨%1⁩ حيث لا تتلامس الدائرتان تغيّرت كمية الحركة الكلية من ⁨%2⁩ إلى ⁦%3 kg m/s⁩؛ يجب أن تبقى</translation>
    </message>
    <message>
        <source>At step %1, where the circles do not touch, the kinetic energy changed from %2 to %3 J; it should stay</source>
        <translation>في الخطوة ⁨%1⁩ حيث لا تتلامس الدائرتان تغيّرت الطاقة الحركية من ⁨%2⁩ إلى ⁦%3 J⁩؛ يجب أن تبقى</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 went from %3 to %4 m/s although it touched neither a wall nor the other circle, from whose rim it was still %5 m away; %6 m/s is right</source>
        <translation>في الخطوة ⁨%1⁩ انتقلت سرعة الدائرة ⁨%2⁩ من ⁦%3⁩ إلى ⁦%4 m/s⁩ مع أنها لم تلامس جدارًا ولا الدائرة الأخرى التي كانت حافتها لا تزال على بعد ⁦%5 m⁩؛ والصحيح ⁦%6 m/s⁩</translation>
    </message>
    <message>
        <source>At step %1 circle 1 left the hit with %2 m/s and circle 2 with %3 m/s; where their line of centres points along %4, %5 and %6 m/s are right</source>
        <translation>في الخطوة ⁨%1⁩ غادرت الدائرة 1 التصادم بسرعة ⁦%2 m/s⁩ والدائرة 2 بسرعة ⁦%3 m/s⁩؛ وحيث يتجه خط المركزين على ⁨%4⁩ فالصحيح ⁨%5⁩ و⁦%6 m/s⁩</translation>
    </message>
    <message>
        <source>%1. Their hit before, at step %2, came out right</source>
        <translation>%1. وتصادمهما السابق، في الخطوة ⁨%2⁩، كان صحيحًا</translation>
    </message>
    <message>
        <source>%1. A wall is reached in this step, too: judge it when the walls are right</source>
        <translation>%1. ويُبلغ جدار أيضًا في هذه الخطوة: احكم عليها حين تصح الجدران</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moves by %3, and in steps before by another method; one for all steps is right</source>
        <translation>في الخطوة ⁨%1⁩ تتحرك الدائرة ⁨%2⁩ بطريقة ⁨%3⁩ وفي خطوات قبلها بطريقة أخرى؛ والصحيح طريقة واحدة لكل الخطوات</translation>
    </message>
    <message>
        <source>None of the four integrators makes all steps of circle %1 under gravity %2 m/s²</source>
        <translation>لا تعطي أي من طرائق التكامل الأربع كل خطوات الدائرة ⁨%1⁩ تحت الجاذبية ⁦%2 m/s²⁩</translation>
    </message>
    <message>
        <source>At step %1 the circles met with %2 m/s along the line of centres, and after the hit they still come nearer, with %3 m/s; they should part with e times as much as they met with: with e = %4, %5 m/s</source>
        <translation>في الخطوة ⁨%1⁩ التقت الدائرتان بسرعة ⁦%2 m/s⁩ على خط المركزين، وبعد التصادم ما زالتا تتقاربان بسرعة ⁦%3 m/s⁩؛ وكان ينبغي أن تتباعدا بمقدار e مرة من سرعة اللقاء: مع ⁦e = %4⁩ بسرعة ⁦%5 m/s⁩</translation>
    </message>
    <message>
        <source>By step %1 the circles have run into each other, and they are answered only in step %2, which begins with their centres %3 m apart; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>عند الخطوة ⁨%1⁩ كانت الدائرتان قد تداخلتا، ولم تأتِ الاستجابة إلا في الخطوة ⁨%2⁩ التي تبدأ والمسافة بين مركزيهما ⁦%3 m⁩؛ وينبغي أن تستجيبا حالما تصير المسافة ⁦r₁ + r₂⁩</translation>
    </message>
    <message>
        <source>Nothing in your program moves the circles: write on_update</source>
        <translation>لا شيء في برنامجك يحرّك الدائرتين: اكتب ⁦on_update⁩</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s, while the circles moved apart and the other one kept its own; it should stay as it was</source>
        <translation>في الخطوة ⁨%1⁩ تغيّرت سرعة الدائرة ⁨%2⁩ من ⁦%3⁩ إلى ⁦%4 m/s⁩ بينما كانت الدائرتان تتباعدان واحتفظت الأخرى بسرعتها؛ يجب أن تبقى كما كانت</translation>
    </message>
    <message>
        <source>At step %1, while the circles did not come nearer, the total momentum changed from %2 to %3 kg m/s; it should stay</source>
        <translation>في الخطوة ⁨%1⁩ حيث لم تتقارب الدائرتان تغيّرت كمية الحركة الكلية من ⁨%2⁩ إلى ⁦%3 kg m/s⁩؛ يجب أن تبقى</translation>
    </message>
    <message>
        <source>At step %1, while the circles did not come nearer, the kinetic energy changed from %2 to %3 J; it should stay</source>
        <translation>في الخطوة ⁨%1⁩ حيث لم تتقارب الدائرتان تغيّرت الطاقة الحركية من ⁨%2⁩ إلى ⁦%3 J⁩؛ يجب أن تبقى</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, circle %2 moved by %3 m; its velocity times the timestep is %4 m. Hits are judged once this is mended</source>
        <translation>في الخطوة ⁨%1⁩ حيث لا تلامس شيئًا تحرّكت الدائرة ⁨%2⁩ بمقدار ⁦%3 m⁩؛ وسرعتها مضروبة في الخطوة الزمنية ⁦%4 m⁩. يُحكم على التصادمات بعد إصلاح ذلك</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, circle %2 moved by %3 m; its velocity times the timestep is %4 m, and gravity adds at most %5 m. Hits are judged once this is mended</source>
        <translation>في الخطوة ⁨%1⁩ حيث لا تلامس شيئًا تحركت الدائرة ⁨%2⁩ بمقدار ⁦%3 m⁩؛ وسرعتها مضروبةً في الخطوة الزمنية ⁦%4 m⁩، وتضيف الجاذبية ⁦%5 m⁩ على الأكثر. يُحكم على التصادمات بعد إصلاح ذلك</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, the velocity of circle %2 went from %3 to %4 m/s; %5 m/s is right. Hits are judged once this is mended</source>
        <translation>في الخطوة ⁨%1⁩ حيث لا تلامس شيئًا انتقلت سرعة الدائرة ⁨%2⁩ من ⁦%3⁩ إلى ⁦%4 m/s⁩؛ والصحيح ⁦%5 m/s⁩. يُحكم على التصادمات بعد إصلاح ذلك</translation>
    </message>
    <message>
        <source>In %2 s circle %1 never came to the floor as fast as a fall makes it; that must be seen to judge how it comes to rest</source>
        <translation>خلال ⁦%2 s⁩ لم تصل الدائرة ⁨%1⁩ إلى الأرضية قط بسرعة يصنعها السقوط؛ يجب أن يُرى ذلك للحكم على وصولها إلى السكون</translation>
    </message>
    <message>
        <source>. Nothing moved</source>
        <translation>. لم يتحرك شيء</translation>
    </message>
    <message>
        <source>. From %1 s on nothing moved</source>
        <translation>. ابتداءً من ⁦%1 s⁩ لم يتحرك شيء</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of a wall or beyond it, for %2 s of another circle: look at what it does there</source>
        <translation>. كانت ⁦%1 s⁩ على بعد خطوة على الأكثر من جدار أو وراءه، و⁦%2 s⁩ من دائرة أخرى: انظر ما تفعله هناك</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of a wall or beyond it: look at what it does there</source>
        <translation>. كانت ⁦%1 s⁩ على بعد خطوة على الأكثر من جدار أو وراءه: انظر ما تفعله هناك</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of another circle: look at what it does there</source>
        <translation>. كانت ⁦%1 s⁩ على بعد خطوة على الأكثر من دائرة أخرى: انظر ما تفعله هناك</translation>
    </message>
    <message>
        <source>At step %1, which began away from the walls, the velocity of circle %2 went from %3 to %4 m/s; %5 m/s is right. Hits are judged once this is mended</source>
        <translation>في الخطوة ⁨%1⁩ التي بدأت بعيدًا عن الجدران انتقلت سرعة الدائرة ⁨%2⁩ من ⁦%3⁩ إلى ⁦%4 m/s⁩؛ والصحيح ⁦%5 m/s⁩. يُحكم على التصادمات بعد إصلاح ذلك</translation>
    </message>
    <message>
        <source>In %2 s circle %1 never came to the floor; that must be seen to judge how it comes to rest</source>
        <translation>خلال ⁦%2 s⁩ لم تصل الدائرة ⁨%1⁩ إلى الأرضية قط؛ يجب أن يُرى ذلك للحكم على وصولها إلى السكون</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m nearer to the other one than its velocities before and after it take it; a hit may move circles apart, not into each other</source>
        <translation>في الخطوة ⁨%1⁩ وضع التصادم الدائرة ⁨%2⁩ أقرب إلى الأخرى بمقدار ⁦%3 m⁩ مما تأخذها إليه سرعتاها قبله وبعده؛ يجوز أن يباعد التصادم بين الدائرتين، لا أن يُدخل إحداهما في الأخرى</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m farther from the other one than its velocities and twice what they overlapped explain; it is enough that they touch</source>
        <translation>في الخطوة ⁨%1⁩ وضع التصادم الدائرة ⁨%2⁩ أبعد عن الأخرى بمقدار ⁦%3 m⁩ مما تفسره سرعتاها وضعف التداخل؛ يكفي أن تتلامسا</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m to the side of the ways that its velocities before and after it take it; a hit may move circles apart along the line of centres only</source>
        <translation>في الخطوة ⁨%1⁩ وضع التصادم الدائرة ⁨%2⁩ على بعد ⁦%3 m⁩ جانبًا عن المسارات التي تأخذها فيها سرعتاها قبله وبعده؛ لا يجوز أن يباعد التصادم بين الدائرتين إلا على امتداد خط المركزين</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m further in from the %3 than its velocities and twice the way of its rim beyond the wall explain; it is enough that its rim is at the wall</source>
        <translation>في الخطوة ⁨%1⁩ وُضعت الدائرة ⁨%2⁩ أبعد إلى الداخل عن ⁨%3⁩ بمقدار ⁦%4 m⁩ مما تفسره سرعتاها وضعف المسافة التي تجاوزت بها حافتها الجدار؛ يكفي أن تكون حافتها عند الجدار</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m further out at the %3 than its velocity takes it; it belongs where its rim is at the wall, or back</source>
        <translation>في الخطوة ⁨%1⁩ وُضعت الدائرة ⁨%2⁩ عند ⁨%3⁩ أبعد إلى الخارج بمقدار ⁦%4 m⁩ مما تأخذها إليه سرعتها؛ مكانها حيث تكون حافتها عند الجدار، أو من حيث جاءت</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m along the %3 beside the ways that its velocities before and after it take it; a wall should move it inward only, or back</source>
        <translation>في الخطوة ⁨%1⁩ وُضعت الدائرة ⁨%2⁩ على بعد ⁦%4 m⁩ على امتداد ⁨%3⁩ جانبًا عن المسارات التي تأخذها فيها سرعتاها قبله وبعده؛ ينبغي أن يزيحها الجدار إلى الداخل فقط، أو أن تعود من حيث جاءت</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s although the circles were moving apart, with %5 m between their rims</source>
        <translation>في الخطوة ⁨%1⁩ تغيّرت سرعة الدائرة ⁨%2⁩ من ⁦%3⁩ إلى ⁦%4 m/s⁩ مع أن الدائرتين كانتا تتباعدان وبين حافتيهما ⁦%5 m⁩</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 went from %3 to %4 m/s although the circles were moving apart, with %5 m between their rims; %6 m/s is right</source>
        <translation>في الخطوة ⁨%1⁩ انتقلت سرعة الدائرة ⁨%2⁩ من ⁦%3⁩ إلى ⁦%4 m/s⁩ مع أن الدائرتين كانتا تتباعدان وبين حافتيهما ⁦%5 m⁩؛ والصحيح ⁦%6 m/s⁩</translation>
    </message>
    <message>
        <source>After a hit at step %1 circle %2 has a velocity of %3 m/s, away from what it hit. From there to step %4 it moved by %5 m; with its velocity it comes %6 m far</source>
        <translation>بعد تصادم في الخطوة ⁨%1⁩ سرعة الدائرة ⁨%2⁩ هي ⁦%3 m/s⁩، تبتعد بها عمّا صدمته. ومن هناك إلى الخطوة ⁨%4⁩ تحركت بمقدار ⁦%5 m⁩؛ وبسرعتها تقطع ⁦%6 m⁩</translation>
    </message>
</context>
<context>
    <name>CircleClipboard</name>
    <message>
        <source>The clipboard is empty: copy circles first</source>
        <translation>الحافظة فارغة: انسخ دوائر أولًا</translation>
    </message>
    <message>
        <source>The clipboard holds too much text to be circles</source>
        <translation>في الحافظة نص أطول من أن يكون دوائر</translation>
    </message>
    <message>
        <source>The clipboard holds no circles: %1</source>
        <translation>لا دوائر في الحافظة: ⁨%1⁩</translation>
    </message>
    <message>
        <source>The scene on the clipboard has no circles</source>
        <translation>المشهد الذي في الحافظة بلا دوائر</translation>
    </message>
</context>
<context>
    <name>CircleName</name>
    <message>
        <source>circle %1</source>
        <translation>الدائرة %1</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>an object with an answer for each id of a question is right</source>
        <translation>الصواب كائن فيه إجابة لكل معرّف سؤال</translation>
    </message>
    <message>
        <source>Judges a program, or with --preset alone the engine&apos;s laws, for one step: by what they do. A program that does not load or that stops does not pass; why is also on standard error, as FILE:LINE: message.</source>
        <translation>يحكم على برنامج، أو على قوانين المحرّك مع ⁦--preset⁩ وحده، لمرحلة واحدة: بما يفعله. البرنامج الذي لا يُحمَّل أو يتوقف لا يجتاز؛ والسبب أيضًا على مخرج الأخطاء القياسي بصيغة ⁦FILE:LINE: message⁩.</translation>
    </message>
    <message>
        <source>the step, like L42T5</source>
        <translation>المرحلة، مثل L42T5</translation>
    </message>
    <message>
        <source>the program to judge; - is standard input</source>
        <translation>البرنامج المراد الحكم عليه؛ - هو المدخل القياسي</translation>
    </message>
    <message>
        <source>the scene; without it that of the step</source>
        <translation>المشهد؛ ومن دونه مشهد المرحلة</translation>
    </message>
    <message>
        <source>the answers to the step&apos;s questions: {&quot;ID&quot;: ANSWER}</source>
        <translation>الإجابات عن أسئلة المرحلة: ⁦{&quot;ID&quot;: ANSWER}⁩</translation>
    </message>
    <message>
        <source>number of the student for whom the lab draws its values</source>
        <translation>رقم الطالب الذي يختار المختبر قيمه له</translation>
    </message>
    <message>
        <source>the lab&apos;s folder or NAME.cradle; without it the shipped lab</source>
        <translation>مجلد المختبر أو ⁦NAME.cradle⁩؛ ومن دونه المختبر المرفق</translation>
    </message>
    <message>
        <source>of the scenes; 1 without it</source>
        <translation>للمشاهد؛ ومن دونه 1</translation>
    </message>
    <message>
        <source>one of %1; text without it</source>
        <translation>واحد من ⁨%1⁩؛ ومن دونه text</translation>
    </message>
    <message>
        <source>where to write; without it the terminal</source>
        <translation>أين يُكتب؛ ومن دونه الطرفية</translation>
    </message>
    <message>
        <source>judge only where rlimits, seccomp and namespaces are to be had</source>
        <translation>الحكم فقط حيث تتوفر rlimits وseccomp وnamespaces</translation>
    </message>
    <message>
        <source>exit with 0 also if it did not pass</source>
        <translation>الخروج بـ 0 حتى إن لم يجتز</translation>
    </message>
    <message>
        <source>SCRIPT.lua or --preset P.json is missing: what is to be judged?</source>
        <translation>⁦SCRIPT.lua⁩ أو ⁦--preset P.json⁩ ناقص: علامَ يُحكم؟</translation>
    </message>
    <message>
        <source>unknown format %1; one of %2 is right</source>
        <translation>صيغة غير معروفة ⁨%1⁩؛ الصواب واحدة من ⁨%2⁩</translation>
    </message>
    <message>
        <source>--seed %1 is not a whole number</source>
        <translation>⁦--seed %1⁩ ليس عددًا صحيحًا</translation>
    </message>
    <message>
        <source>the lab has no step %1; it has %2</source>
        <translation>ليس في المختبر مرحلة ⁨%1⁩؛ فيه ⁨%2⁩</translation>
    </message>
    <message>
        <source>left out of the zip: %1</source>
        <translation>لم يوضع في ملف zip: ⁨%1⁩</translation>
    </message>
    <message>
        <source>the results may not go where the submissions are</source>
        <translation>لا يجوز أن تذهب النتائج إلى حيث التسليمات</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>لا يوجد مجلد ⁨%1⁩</translation>
    </message>
    <message>
        <source>a secret was made for the scenes of this class: %1; keep it, and publish it to nobody</source>
        <translation>أُنشئ سرّ لمشاهد هذا الصف: ⁨%1⁩؛ احفظه ولا تنشره لأحد</translation>
    </message>
    <message>
        <source>the lab</source>
        <translation>المختبر</translation>
    </message>
    <message>
        <source>the secret</source>
        <translation>السرّ</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>اللغة</translation>
    </message>
    <message>
        <source>--require-isolation: this machine has only: %1</source>
        <translation>⁦--require-isolation⁩: في هذا الجهاز فقط: ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 holds results of another version (%2); another folder is right, or --again to begin anew</source>
        <translation>في ⁨%1⁩ نتائج نسخة أخرى (⁨%2⁩)؛ الصواب مجلد آخر، أو ⁦--again⁩ للبدء من جديد</translation>
    </message>
    <message>
        <source>the shard</source>
        <translation>الجزء</translation>
    </message>
    <message>
        <source>programs: %1</source>
        <translation>البرامج: ⁨%1⁩</translation>
    </message>
    <message>
        <source>nothing to judge</source>
        <translation>لا شيء للحكم عليه</translation>
    </message>
    <message>
        <source>missing: %1 %2</source>
        <translation>ناقص: ⁦%1 %2⁩</translation>
    </message>
    <message>
        <source>students: %1</source>
        <translation>الطلاب: ⁨%1⁩</translation>
    </message>
    <message>
        <source>none of the folders has the lab; --lab LAB is right</source>
        <translation>ليس المختبر في أي من المجلدات؛ الصواب ⁦--lab LAB⁩</translation>
    </message>
    <message>
        <source>the results were judged by another version of the lab</source>
        <translation>حُكم على النتائج بنسخة أخرى من المختبر</translation>
    </message>
    <message>
        <source>the results of all may not go where those of a shard are</source>
        <translation>لا يجوز أن تذهب نتائج الجميع إلى حيث نتائج جزء</translation>
    </message>
    <message>
        <source>--language %1: the results are in the language %2, in which they were judged</source>
        <translation>⁦--language %1⁩: النتائج باللغة ⁨%2⁩ التي حُكم بها</translation>
    </message>
    <message>
        <source>%1 holds results of another version; another folder is right, or --again to begin anew</source>
        <translation>في ⁨%1⁩ نتائج نسخة أخرى؛ الصواب مجلد آخر، أو ⁦--again⁩ للبدء من جديد</translation>
    </message>
    <message>
        <source>isolation: %1</source>
        <translation>العزل: ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 of %2 students</source>
        <translation>الطلاب: ⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message>
        <source>, %1 a minute, %2 left</source>
        <translation>، ⁨%1⁩ في الدقيقة، بقي ⁨%2⁩</translation>
    </message>
    <message>
        <source>, %1 steps not passed</source>
        <translation>، مراحل لم تُجتز: ⁨%1⁩</translation>
    </message>
    <message>
        <source>, %1 not graded</source>
        <translation>، مراحل لم تُقيَّم: ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 of %2 students, %3 of them as they were before; steps: %4 passed, %5 not passed, %6 not graded; %7</source>
        <translation>الطلاب: ⁨%1⁩ من ⁨%2⁩، منهم كما كانوا من قبل: ⁨%3⁩؛ المراحل: اجتيزت ⁨%4⁩، لم تُجتز ⁨%5⁩، لم تُقيَّم ⁨%6⁩؛ ⁨%7⁩</translation>
    </message>
    <message>
        <source>the folder of the results</source>
        <translation>مجلد النتائج</translation>
    </message>
    <message>
        <source>from which, with the id, each student&apos;s scenes follow; without it one is made and kept in RESULTS/secret.txt</source>
        <translation>السرّ الذي تنتج منه، مع المعرّف، مشاهد كل طالب؛ ومن دونه يُنشأ واحد ويُحفظ في ⁦RESULTS/secret.txt⁩</translation>
    </message>
    <message>
        <source>students at a time; without it as many as processors</source>
        <translation>عدد الطلاب في وقت واحد؛ ومن دونه بعدد المعالجات</translation>
    </message>
    <message>
        <source>who is in the class: a table with columns id, folder, name, number, email, late days</source>
        <translation>من في الصف: جدول بالأعمدة id وfolder وname وnumber وemail و⁦late days⁩</translation>
    </message>
    <message>
        <source>what each late day takes of the points; 0 without it</source>
        <translation>ما يأخذه كل يوم تأخير من النقاط؛ ومن دونه 0</translation>
    </message>
    <message>
        <source>more percent are never taken; 100 without it</source>
        <translation>لا تؤخذ نسبة مئوية أكبر أبدًا؛ ومن دونه 100</translation>
    </message>
    <message>
        <source>judge part I of N of the class, for --merge</source>
        <translation>الحكم على الجزء I من N من الصف، من أجل ⁦--merge⁩</translation>
    </message>
    <message>
        <source>judge nothing; put together the results of shards, each a folder</source>
        <translation>لا حكم؛ بل جمع نتائج الأجزاء، كلٌّ منها مجلد</translation>
    </message>
    <message>
        <source>tell how the folder was understood, and judge nothing</source>
        <translation>بيان كيف فُهم المجلد، دون حكم</translation>
    </message>
    <message>
        <source>begin anew where RESULTS holds those of another version</source>
        <translation>البدء من جديد حيث في RESULTS نتائج نسخة أخرى</translation>
    </message>
    <message>
        <source>text, or json: events on standard output, one a line</source>
        <translation>‏text، أو json: أحداث على المخرج القياسي، واحد في كل سطر</translation>
    </message>
    <message>
        <source>exit with 0 also if somebody did not pass, if only all are graded</source>
        <translation>الخروج بـ 0 حتى إن لم يجتز أحدهم، ما دام الجميع قد قُيّموا</translation>
    </message>
    <message>
        <source>--jobs %1: a number from 1 to %2 is right</source>
        <translation>⁦--jobs %1⁩: الصواب عدد من 1 إلى ⁨%2⁩</translation>
    </message>
    <message>
        <source>--shard %1: I/N is right, with I from 1 to N</source>
        <translation>⁦--shard %1⁩: الصواب ⁦I/N⁩، حيث I من 1 إلى N</translation>
    </message>
    <message>
        <source>--shard needs --secret FILE, the same for every shard</source>
        <translation>يحتاج ⁦--shard⁩ إلى ⁦--secret FILE⁩، واحد لكل الأجزاء</translation>
    </message>
    <message>
        <source>--late-percent and --late-most are numbers from 0 to 100</source>
        <translation>⁦--late-percent⁩ و⁦--late-most⁩ عددان من 0 إلى 100</translation>
    </message>
    <message>
        <source>Judges a class: every step of every student, each in a process of its own that can do nothing else. SUBMISSIONS is a folder of folders or of .cradle-work files, a download of Moodle, Canvas or Blackboard, clones of GitHub Classroom, or a zip of any of these; nothing in it is written. Stopped at any time it goes on where it was. Exit status: 1 if not all passed.</source>
        <translation>يحكم على صف: كل مرحلة لكل طالب، كلٌّ في عملية خاصة لا تستطيع فعل شيء آخر. SUBMISSIONS مجلد فيه مجلدات أو ملفات ⁦.cradle-work⁩، أو تنزيل من Moodle أو Canvas أو Blackboard، أو نسخ من ⁦GitHub Classroom⁩، أو ملف zip لأيٍّ منها؛ ولا يُكتب فيه شيء. وإن أُوقف في أي وقت واصل من حيث كان. حالة الخروج: 1 إن لم يجتز الجميع.</translation>
    </message>
    <message>
        <source>what was handed in; with --merge: results</source>
        <translation>ما سُلِّم؛ ومع ⁦--merge⁩: النتائج</translation>
    </message>
    <message>
        <source>unexpected argument %1; see %2 --help</source>
        <translation>وسيط غير متوقع ⁨%1⁩؛ انظر ⁦%2 --help⁩</translation>
    </message>
    <message>
        <source>--out RESULTS is missing: where are the results to go?</source>
        <translation>⁦--out RESULTS⁩ ناقص: إلى أين تذهب النتائج؟</translation>
    </message>
    <message>
        <source>there is no verdict; of the process that judged: %1</source>
        <translation>لا يوجد حكم؛ من العملية التي حكمت: ⁨%1⁩</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>هذا مجلد؛ الصواب ملف</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>تتعذر قراءته: ⁨%1⁩</translation>
    </message>
    <message>
        <source>the application that prints PDF is not beside cradle-cli; F.html is right without it</source>
        <translation>التطبيق الذي يطبع PDF ليس بجوار ⁦cradle-cli⁩؛ الصواب ⁦F.html⁩ من دونه</translation>
    </message>
    <message>
        <source>the report could not be printed: %1</source>
        <translation>تعذّرت طباعة التقرير: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Runs a scene, by its laws or by a program, and writes what happens: tables, or without any a summary. If the program stops, why is on standard error as FILE:LINE: message, the tables reach up to there, and the exit status is 1. Ctrl+C ends the run: what is written reaches up to there, and the exit status is 130.</source>
        <translation>يشغّل مشهدًا، بقوانينه أو ببرنامج، ويكتب ما يحدث: جداول، أو ملخصًا إن لم تُطلب. إذا توقف البرنامج فالسبب على مخرج الأخطاء القياسي بصيغة ⁦FILE:LINE: message⁩، والجداول تصل إلى هناك، وحالة الخروج 1. ⁦Ctrl+C⁩ ينهي التشغيل: ما كُتب يصل إلى هناك، وحالة الخروج 130.</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>المشهد</translation>
    </message>
    <message>
        <source>stopped at %1 s</source>
        <translation>توقف عند ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>%1 % of the run; Ctrl+C ends it here</source>
        <translation>⁦%1 %⁩ من التشغيل؛ ⁦Ctrl+C⁩ ينهيه هنا</translation>
    </message>
    <message>
        <source>how long, s</source>
        <translation>كم يستمر، s</translation>
    </message>
    <message>
        <source>instead of the preset&apos;s, s</source>
        <translation>بدلًا من خطوة المشهد، s</translation>
    </message>
    <message>
        <source>discrete, continuous or exact</source>
        <translation>‏discrete أو continuous أو exact</translation>
    </message>
    <message>
        <source>a program that moves the circles; what it prints goes to standard error, what it plots and draws is dropped, its hits are inferred</source>
        <translation>برنامج يحرّك الدوائر؛ ما يطبعه يذهب إلى مخرج الأخطاء القياسي، وما يرسمه يُترك، وتصادماته تُستنتج</translation>
    </message>
    <message>
        <source>write every N-th step only</source>
        <translation>كتابة خطوة واحدة فقط من كل N خطوة</translation>
    </message>
    <message>
        <source>table of the circles&apos; states</source>
        <translation>جدول حالات الدوائر</translation>
    </message>
    <message>
        <source>table of momentum and energy</source>
        <translation>جدول كمية الحركة والطاقة</translation>
    </message>
    <message>
        <source>table of the hits</source>
        <translation>جدول التصادمات</translation>
    </message>
    <message>
        <source>of the summary: text, or json, which is written beside tables, too</source>
        <translation>صيغة الملخص: text، أو json الذي يُكتب إلى جانب الجداول أيضًا</translation>
    </message>
    <message>
        <source>--%1 %2 is not right; %3 is right</source>
        <translation>⁦--%1 %2⁩ ليس صوابًا؛ الصواب ⁨%3⁩</translation>
    </message>
    <message>
        <source>a number above 0 and at most %1</source>
        <translation>عدد أكبر من 0 ولا يتجاوز ⁨%1⁩</translation>
    </message>
    <message>
        <source>a table and the summary cannot both go to standard output; a file for the table is right</source>
        <translation>لا يمكن أن يذهب جدول والملخص معًا إلى المخرج القياسي؛ الصواب ملف للجدول</translation>
    </message>
    <message>
        <source>--duration S is missing: how long, in s?</source>
        <translation>⁦--duration S⁩ ناقص: كم، بوحدة s؟</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>عدد صحيح ابتداء من 1</translation>
    </message>
    <message>
        <source>%1 steps are too many; at most %2 are right</source>
        <translation>عدد الخطوات ⁨%1⁩ كبير جدًّا؛ الصواب ⁨%2⁩ على الأكثر</translation>
    </message>
    <message>
        <source>contacts merged from %1 s on</source>
        <translation>دُمجت التلامسات من ⁦%1 s⁩ فصاعدًا</translation>
    </message>
    <message>
        <source>%1: %2 circles, %3 steps, %4 s, %5 hits
momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J
</source>
        <translation>⁨%1⁩: عدد الدوائر ⁨%2⁩، الخطوات ⁨%3⁩، ⁦%4 s⁩، التصادمات ⁨%5⁩
كمية الحركة ⁦(%6, %7) kg m/s⁩، الحركية ⁦%8 J⁩، الكامنة ⁦%9 J⁩
</translation>
    </message>
    <message>
        <source>an argument is missing; see %1 --help</source>
        <translation>وسيط ناقص؛ انظر ⁦%1 --help⁩</translation>
    </message>
    <message>
        <source>      passes every check
</source>
        <translation>      يجتاز كل فحص
</translation>
    </message>
    <message>
        <source>      fails %1 without a diagnosis: %2
</source>
        <translation>      يخفق في ⁨%1⁩ دون تشخيص: ⁨%2⁩
</translation>
    </message>
    <message>
        <source>the lab&apos;s folder, or NAME.cradle</source>
        <translation>مجلد المختبر، أو ⁦NAME.cradle⁩</translation>
    </message>
    <message>
        <source>this step alone</source>
        <translation>هذه المرحلة وحدها</translation>
    </message>
    <message>
        <source>It was stopped after %1 s of processor time.</source>
        <translation>أُوقف بعد ⁦%1 s⁩ من وقت المعالج.</translation>
    </message>
    <message>
        <source>It was stopped: it asked the system for what no program needs.</source>
        <translation>أُوقف: طلب من النظام ما لا يحتاج إليه برنامج.</translation>
    </message>
    <message>
        <source>The process that judged it broke down.</source>
        <translation>انهارت العملية التي حكمت عليه.</translation>
    </message>
    <message>
        <source>No process could be had to judge it.</source>
        <translation>لم تتوفر عملية للحكم عليه.</translation>
    </message>
    <message>
        <source>%1 programs became differences, %2 lines fewer</source>
        <translation>برامج صارت فروقًا: ⁨%1⁩؛ أسطر وُفّرت: ⁨%2⁩</translation>
    </message>
    <message>
        <source>Judges a lab itself: starters fail by a check, solutions pass, every known mistake fails and is recognised, and every check is failed by a mistake. Prints which mistake (row) fails which check (column, x) and what it is taken for.</source>
        <translation>يحكم على المختبر نفسه: برامج البداية تخفق في فحص، والحلول تجتاز، وكل خطأ معروف يخفق ويُتعرَّف عليه، وكل فحص يخفق فيه خطأ. يطبع أي خطأ (صف) يخفق في أي فحص (عمود، x) وبماذا يُشخَّص.</translation>
    </message>
    <message>
        <source>keep mistakes and remarks as differences from their solution where that is shorter</source>
        <translation>حفظ الأخطاء والتعقيبات فروقًا عن حلّها حيث يكون ذلك أقصر</translation>
    </message>
    <message>
        <source>also ask of every check whether some change of the solution fails by it alone; takes minutes</source>
        <translation>السؤال كذلك عن كل فحص هل يخفق تغييرٌ ما في الحل بسببه وحده؛ يستغرق دقائق</translation>
    </message>
    <message>
        <source>with how many seeds every solution is judged, 1 to 1000</source>
        <translation>بكم بذرة يُحكم على كل حل، من 1 إلى 1000</translation>
    </message>
    <message>
        <source>--seeds takes a whole number from 1 to 1000, not %1</source>
        <translation>يأخذ ⁦--seeds⁩ عددًا صحيحًا من 1 إلى 1000، لا ⁨%1⁩</translation>
    </message>
    <message>
        <source>the lab&apos;s folder or NAME.cradle; without it the shipped lab that the work belongs to</source>
        <translation>مجلد المختبر أو ⁦NAME.cradle⁩؛ ومن دونه المختبر المرفق الذي ينتمي إليه العمل</translation>
    </message>
    <message>
        <source>of the student</source>
        <translation>الطالب</translation>
    </message>
    <message>
        <source>to the teacher</source>
        <translation>إلى المدرّس</translation>
    </message>
    <message>
        <source>where to write</source>
        <translation>أين يُكتب</translation>
    </message>
    <message>
        <source>Writes the report of a student&apos;s work: what was asked, what the program does, how it came about. Every step is judged anew.</source>
        <translation>يكتب تقرير عمل طالب: ما طُلب، وما يفعله البرنامج، وكيف نشأ. يُحكم على كل مرحلة من جديد.</translation>
    </message>
    <message>
        <source>the folder, or a FILE.cradle-work</source>
        <translation>المجلد، أو ⁦FILE.cradle-work⁩</translation>
    </message>
    <message>
        <source>--output F.pdf or --output F.html is right</source>
        <translation>الصواب ⁦--output F.pdf⁩ أو ⁦--output F.html⁩</translation>
    </message>
    <message>
        <source>Writes a student&apos;s work into one file to be handed in: the programs, scenes, notes, the history and a report. Every step is judged once more.</source>
        <translation>يكتب عمل طالب في ملف واحد للتسليم: البرامج والمشاهد والملاحظات والتاريخ وتقرير. يُحكم على كل مرحلة مرة أخرى.</translation>
    </message>
    <message>
        <source>the folder</source>
        <translation>المجلد</translation>
    </message>
    <message>
        <source>--output FILE.cradle-work is right</source>
        <translation>الصواب ⁦--output FILE.cradle-work⁩</translation>
    </message>
    <message>
        <source>this is too long for a program; at most %1 are right</source>
        <translation>هذا أطول من أن يكون برنامجًا؛ الصواب ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>this is text in UTF-16; UTF-8 would be right</source>
        <translation>هذا نص بترميز ⁦UTF-16⁩؛ الصواب ⁦UTF-8⁩</translation>
    </message>
    <message>
        <source>this is no text in UTF-8, which would be right</source>
        <translation>هذا ليس نصًّا بترميز ⁦UTF-8⁩، وهو الصواب</translation>
    </message>
    <message>
        <source>of the pages and of what students are told, such as en or de; en without it</source>
        <translation>للصفحات ولما يقرؤه الطلاب، مثل en أو ar؛ ومن دونها en</translation>
    </message>
    <message>
        <source>--language %1: one of %2 is right</source>
        <translation>⁦--language %1⁩: الصواب واحدة من ⁨%2⁩</translation>
    </message>
    <message>
        <source>of the report, such as en or de; without it that of the system</source>
        <translation>للتقرير، مثل en أو ar؛ ومن دونها لغة النظام</translation>
    </message>
    <message>
        <source>Writes a lab into one file. For students it leaves out solutions, mistakes, remarks and files that no step uses; what checks and questions ask for stays.</source>
        <translation>يكتب مختبرًا في ملف واحد. للطلاب يُسقط الحلول والأخطاء والتعقيبات والملفات التي لا تستعملها أي مرحلة؛ ويبقى ما تطلبه الفحوص والأسئلة.</translation>
    </message>
    <message>
        <source>leave out what students shall find</source>
        <translation>ترك ما يُراد من الطلاب أن يجدوه</translation>
    </message>
    <message>
        <source>the file to write; needed</source>
        <translation>الملف الذي يُكتب؛ لازم</translation>
    </message>
    <message>
        <source>--output is missing: the file to write</source>
        <translation>⁦--output⁩ ناقص: الملف الذي يُكتب</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) left out</source>
        <translation>
            <numerusform>لم يُترك أي ملف</numerusform>
            <numerusform>تُرك ملف واحد</numerusform>
            <numerusform>تُرك ملفان</numerusform>
            <numerusform>تُركت %n ملفات</numerusform>
            <numerusform>تُرك %n ملفًا</numerusform>
            <numerusform>تُرك %n ملف</numerusform>
        </translation>
    </message>
    <message>
        <source>students are told what checks saw, and not which law is wrong, in %1: these checks tell no law</source>
        <translation>في ⁨%1⁩ يقرأ الطلاب ما رأته الفحوص لا أيّ قانون هو الخطأ: هذه الفحوص لا تذكر قانونًا</translation>
    </message>
    <message>
        <source>this is an edition for students, without the solutions and mistakes that prove a lab; the whole lab is right</source>
        <translation>هذه طبعة للطلاب بلا الحلول والأخطاء التي تثبت صحة المختبر؛ الصواب هو المختبر كله</translation>
    </message>
    <message>
        <source>writing, %1 of %2</source>
        <translation>تجري الكتابة، %1 من %2</translation>
    </message>
    <message>
        <source>there is nothing of that name; the name of something new must be UTF-8</source>
        <translation>لا يوجد شيء بهذا الاسم؛ واسم كل جديد يجب أن يكون بترميز UTF-8</translation>
    </message>
    <message>
        <source>of what the student is told, such as en or de; en without it</source>
        <translation>لما يقرؤه الطالب، مثل en أو ar؛ ومن دونها en</translation>
    </message>
    <message>
        <source>the step %1 cannot be read; why is said above</source>
        <translation>لا يمكن قراءة المرحلة ⁨%1⁩؛ والسبب مذكور أعلاه</translation>
    </message>
    <message>
        <source>of files of a lab that draws values: those of the student with this number</source>
        <translation>لملفات مختبر يختار القيم: قيم الطالب صاحب هذا الرقم</translation>
    </message>
    <message>
        <source>      fails %1; what is measured tells: %2
</source>
        <translation>      يخفق في ⁨%1⁩؛ والمقيس يقول: ⁨%2⁩
</translation>
    </message>
    <message>
        <source>Makes mistakes that students make out of the solutions of a lab, and names those that pass every check (a check may be missing), those that fail without a diagnosis (a mistake may be missing), and those of which a law that is measured tells.</source>
        <translation>يصنع من حلول المختبر أخطاء كالتي يرتكبها الطلاب، ويسمّي ما يجتاز كل الفحوص (فقد ينقص فحص)، وما يخفق بلا تشخيص (فقد ينقص خطأ)، وما يخبر عنه قانون مقيس.</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>لا مراحل</numerusform>
            <numerusform>مرحلة واحدة</numerusform>
            <numerusform>مرحلتان</numerusform>
            <numerusform>%n مراحل</numerusform>
            <numerusform>%n مرحلة</numerusform>
            <numerusform>%n مرحلة</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mistakes</source>
        <translation>
            <numerusform>لا أخطاء</numerusform>
            <numerusform>خطأ واحد</numerusform>
            <numerusform>خطآن</numerusform>
            <numerusform>%n أخطاء</numerusform>
            <numerusform>%n خطأ</numerusform>
            <numerusform>%n خطأ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>لا مشكلات</numerusform>
            <numerusform>مشكلة واحدة</numerusform>
            <numerusform>مشكلتان</numerusform>
            <numerusform>%n مشكلات</numerusform>
            <numerusform>%n مشكلة</numerusform>
            <numerusform>%n مشكلة</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>⁦%1 s⁩</translation>
    </message>
    <message>
        <source>the folder %1 is no step: lab.json does not list it
</source>
        <translation>المجلد ⁨%1⁩ ليس مرحلة: لا يذكره ⁦lab.json⁩
</translation>
    </message>
    <message>
        <source>Values of students that were tried:
</source>
        <translation>قيم الطلاب التي جُرّبت:
</translation>
    </message>
    <message>
        <source>%1 is written: %2 of %3 steps passed</source>
        <translation>كُتب ⁨%1⁩: المراحل المجتازة ⁨%2⁩ من ⁨%3⁩</translation>
    </message>
</context>
<context>
    <name>Deviation</name>
    <message>
        <source>%1 m</source>
        <comment>a distance</comment>
        <translation>⁦%1 m⁩</translation>
    </message>
    <message>
        <source>up to %1 m (rms %2 m)</source>
        <translation>حتى ⁦%1 m⁩ (الجذر التربيعي لمتوسط المربعات ⁦%2 m⁩)</translation>
    </message>
    <message>
        <source>%1 J</source>
        <comment>an energy, with its sign</comment>
        <translation>⁦%1 J⁩</translation>
    </message>
    <message>
        <source>Off the exact motion: %1, %2.</source>
        <comment>energy, distance</comment>
        <translation>الفرق عن الحركة الدقيقة: ⁨%1⁩، ⁨%2⁩.</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>A thousand equal circles start with the same speed, 2 m/s, in all directions. Press Run and watch the speeds at the bottom right.

No hit is aimed at anything, yet within a second or two the speeds spread until they lie along one curve, that of Maxwell and Boltzmann. No energy is lost: only how the circles share it changes.

- Go back on the timeline: the curve is the same all the time, as it depends on the mean energy alone.
- Set the restitution to 0.99: the gas cools, and the curve moves to the left.
- The colours say which half a circle comes from. They mix much more slowly than the speeds.</source>
        <translation>تنطلق ألف دائرة متساوية بمقدار السرعة نفسه، ⁦2 m/s⁩، في كل الاتجاهات. اضغط «تشغيل» وراقب مقادير السرعات في الأسفل.

لم يُصوَّب أي تصادم نحو شيء، ومع ذلك تتوزع السرعات خلال ثانية أو اثنتين حتى تقع على منحنى واحد، منحنى ماكسويل وبولتزمان. لا تُفقد أي طاقة: إنما يتغير توزعها بين الدوائر.

- ارجع على خط الزمن: المنحنى هو نفسه طوال الوقت، لأنه يتوقف على متوسط الطاقة وحده.
- اجعل معامل الارتداد 0.99: يبرد الغاز، وينتقل المنحنى نحو السرعات الصغيرة.
- تبيّن الألوان من أي نصف جاءت الدائرة. وهي تمتزج أبطأ بكثير من السرعات.</translation>
    </message>
    <message>
        <source>A heavy circle falls onto a bed of 124 light ones, each of which has a six-thousandth of its mass. Press Run and watch the energy.

A hit with e = 0.9 leaves e² = 81 % of the energy of the motion towards each other. Yet here a fifth of all energy goes in less than a tenth of a second, most of it in two blows, at 0.94 s and 0.99 s: light circles that are caught between the heavy one and the floor are hit to and fro ever faster, hundreds of times in a hundredth of a second. That is how an inelastic collapse begins.

- Go back on the timeline to the blows, and step through them with → and ←.
- Set the restitution to 1: the bed becomes a gas under a piston, and throws it back.</source>
        <translation>تسقط دائرة ثقيلة على فراش من 124 دائرة خفيفة، كتلة كلٍّ منها جزء من ستة آلاف جزء من كتلتها. اضغط «تشغيل» وراقب الطاقة.

التصادم مع ⁦e = 0.9⁩ يُبقي ⁦e² = 81 %⁩ من طاقة حركة الجسمين أحدهما نحو الآخر. لكن خُمس الطاقة كلها يضيع هنا في أقل من عُشر ثانية، ومعظمه في ضربتين، عند ⁦0.94 s⁩ و⁦0.99 s⁩: دوائر خفيفة محصورة بين الثقيلة والأرضية تُصدم ذهابًا وإيابًا أسرع فأسرع، مئات المرات في جزء من مئة من الثانية. هكذا يبدأ الانهيار غير المرن.

- ارجع على خط الزمن إلى الضربتين، وتقدّم فيهما خطوة خطوة بالمفتاحين → و←.
- اجعل معامل الارتداد 1: يصير الفراش غازًا تحت مكبس، ويقذفه إلى أعلى.</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>غاز</translation>
    </message>
    <message>
        <source>Piston drop</source>
        <translation>سقوط مكبس</translation>
    </message>
    <message>
        <source>This scene belongs to no step. Choose a step above to go back to the lab.</source>
        <translation>لا ينتمي هذا المشهد إلى أي مرحلة. اختر مرحلة في الأعلى للعودة إلى المختبر.</translation>
    </message>
</context>
<context>
    <name>Expression</name>
    <message>
        <source>“%1” is not expected there</source>
        <translation>«⁨%1⁩» غير متوقع هناك</translation>
    </message>
    <message>
        <source>it comes to no finite number</source>
        <translation>لا ينتج منه عدد منتهٍ</translation>
    </message>
    <message>
        <source>“%1” is no number: %2</source>
        <translation>«⁨%1⁩» ليس عددًا: ⁨%2⁩</translation>
    </message>
    <message>
        <source>it is too deep</source>
        <translation>أجزاؤه متداخلة أعمق مما ينبغي</translation>
    </message>
    <message>
        <source>a closing parenthesis is missing</source>
        <translation>ينقص قوس إغلاق</translation>
    </message>
    <message>
        <source>something is missing at its end</source>
        <translation>ينقص شيء في نهايته</translation>
    </message>
    <message>
        <source>there is no value called %1</source>
        <translation>لا توجد قيمة اسمها ⁨%1⁩</translation>
    </message>
    <message>
        <source>a parenthesis behind %1 is missing</source>
        <translation>ينقص قوس بعد ⁨%1⁩</translation>
    </message>
    <message>
        <source>a comma and another number are missing</source>
        <translation>تنقص فاصلة وعدد آخر</translation>
    </message>
    <message>
        <source>an expression of at most %1 characters is right</source>
        <translation>الصواب عبارة من ⁨%1⁩ حرفًا على الأكثر</translation>
    </message>
    <message>
        <source>%1 and %2 stand side by side</source>
        <translation>⁨%1⁩ و⁨%2⁩ متجاورتان</translation>
    </message>
    <message>
        <source>a power with that unit is none</source>
        <translation>لا معنى للرفع إلى أُسّ مع هذه الوحدة</translation>
    </message>
    <message>
        <source>there is a unit too many</source>
        <translation>ثمة وحدة زائدة</translation>
    </message>
    <message>
        <source>%1 is taken of a number without a unit, not of one in %2</source>
        <translation>تؤخذ ⁨%1⁩ لعدد بلا وحدة، لا لعدد بوحدة ⁨%2⁩</translation>
    </message>
    <message>
        <source>it is in %1; %2 is right here</source>
        <translation>إنه بوحدة ⁨%1⁩؛ والصواب هنا ⁨%2⁩</translation>
    </message>
</context>
<context>
    <name>FileIo</name>
    <message>
        <source>the disk is full</source>
        <translation>القرص ممتلئ</translation>
    </message>
    <message>
        <source>your share of the disk is full</source>
        <translation>حصتك من القرص ممتلئة</translation>
    </message>
    <message>
        <source>a file may not be so large here</source>
        <translation>لا يجوز أن يكون الملف هنا بهذا الحجم</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>القرص للقراءة فقط</translation>
    </message>
    <message>
        <source>you may not write here</source>
        <translation>لا يجوز لك الكتابة هنا</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>لا يوجد مجلد كهذا</translation>
    </message>
    <message>
        <source>a file is where a folder should be</source>
        <translation>يوجد ملف حيث ينبغي أن يكون مجلد</translation>
    </message>
    <message>
        <source>this is a folder; the name of a file is right</source>
        <translation>هذا مجلد؛ الصواب اسم ملف</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>الاسم طويل جدًّا</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>إنه مغلق</translation>
    </message>
    <message>
        <source>the disk has a fault</source>
        <translation>في القرص عطل</translation>
    </message>
</context>
<context>
    <name>Findings</name>
    <message>
        <source> or </source>
        <translation> أو </translation>
    </message>
    <message>
        <source>Rims touch where the centres are r₁ + r₂ apart, here %1 m.</source>
        <translation>تتلامس الحافتان حين تكون المسافة بين المركزين ⁦r₁&#xa0;+&#xa0;r₂⁩، وهي هنا ⁦%1 m⁩.</translation>
    </message>
    <message>
        <source>Only half of r₁ + r₂ counts in the test of contact</source>
        <translation>لا يُحسب في اختبار التلامس إلا نصف ⁦r₁&#xa0;+&#xa0;r₂⁩</translation>
    </message>
    <message>
        <source>The circles answer only when their centres have met</source>
        <translation>لا تستجيب الدائرتان إلا حين يلتقي مركزاهما</translation>
    </message>
    <message>
        <source>Boxes are compared, not circles</source>
        <translation>تُقارَن المربعات المحيطة لا الدوائر</translation>
    </message>
    <message>
        <source>Side by side they answer in time, but on a diagonal when their centres are still %2 m apart: x and y each on its own ask for squares. Make one distance out of the two differences.</source>
        <translation>جنبًا إلى جنب تستجيبان في الوقت المناسب، أما على خط مائل فحين لا تزال المسافة بين مركزيهما ⁦%2 m⁩: السؤال عن x وحده وعن y وحده سؤال عن مربعين يحيطان بالدائرتين. اجعل من الفرقين مسافة واحدة.</translation>
    </message>
    <message>
        <source>|Δx| + |Δy| is not the distance</source>
        <translation>⁦|Δx| + |Δy|⁩ ليس هو المسافة</translation>
    </message>
    <message>
        <source>Side by side they answer in time, but on a diagonal only when their centres are %2 m apart. A distance is the root of the sum of the squares.</source>
        <translation>جنبًا إلى جنب تستجيبان في الوقت المناسب، أما على خط مائل فلا تستجيبان إلا حين تكون المسافة بين مركزيهما ⁦%2 m⁩. المسافة هي جذر مجموع المربعين.</translation>
    </message>
    <message>
        <source>A squared distance is compared with a length</source>
        <translation>يُقارَن مربع مسافة بطول</translation>
    </message>
    <message>
        <source>Contact is tested at %1, not at r₁ + r₂</source>
        <translation>يُختبر التلامس عند ⁨%1⁩، لا عند ⁦r₁&#xa0;+&#xa0;r₂⁩</translation>
    </message>
    <message>
        <source>the larger radius</source>
        <translation>نصف القطر الأكبر</translation>
    </message>
    <message>
        <source>the smaller radius</source>
        <translation>نصف القطر الأصغر</translation>
    </message>
    <message>
        <source>the difference of the radii</source>
        <translation>فرق نصفي القطرين</translation>
    </message>
    <message>
        <source>twice the larger radius</source>
        <translation>ضعف نصف القطر الأكبر</translation>
    </message>
    <message>
        <source>the sum of the diameters</source>
        <translation>مجموع القطرين</translation>
    </message>
    <message>
        <source>The circles are held and keep their velocities</source>
        <translation>تُمسَك الدائرتان وتحتفظان بسرعتيهما</translation>
    </message>
    <message>
        <source>The circles run through each other</source>
        <translation>تمر الدائرتان إحداهما عبر الأخرى</translation>
    </message>
    <message>
        <source>The circles act on each other</source>
        <translation>تؤثر الدائرتان إحداهما في الأخرى</translation>
    </message>
    <message>
        <source>In this step they should still pass through each other.</source>
        <translation>في هذه المرحلة يجب أن تمر إحداهما عبر الأخرى.</translation>
    </message>
    <message>
        <source>Where they overlapped, your program put circle %1 elsewhere than its velocity takes it. In this step they should still pass through each other.</source>
        <translation>حيث تراكبتا وضع برنامجك الدائرة ⁨%1⁩ في غير المكان الذي تحملها إليه سرعتها. في هذه المرحلة ينبغي أن تعبر كل منهما الأخرى بعد.</translation>
    </message>
    <message>
        <source>The circles are answered long after they meet</source>
        <translation>تستجيب الدائرتان بعد التقائهما بوقت طويل</translation>
    </message>
    <message>
        <source>Circles that overlap at the start of a run and move apart are not answered at once. Look at what is asked before they answer, and at what your program counts, or keeps from one step to the next.</source>
        <translation>الدائرتان المتداخلتان في بداية التشغيل والمتباعدتان لا تستجيبان فورًا. انظر ماذا يُسأل قبل أن تستجيبا، وماذا يعدّ برنامجك أو يحتفظ به من خطوة إلى الخطوة التالية.</translation>
    </message>
    <message>
        <source>The circles answer when they part, not when they meet</source>
        <translation>تستجيب الدائرتان حين تفترقان لا حين تلتقيان</translation>
    </message>
    <message>
        <source>They ran into each other until their centres were %1 m apart, and were answered in the step in which these passed each other; circles that overlap and move apart are not answered. Rims touch where the centres are r₁ + r₂ apart: look at what their distance is compared with.</source>
        <translation>دخلت إحداهما في الأخرى حتى صار مركزاهما على بعد ⁦%1 m⁩، وجاءت الاستجابة في الخطوة التي تجاوز فيها كل منهما الآخر؛ أما الدوائر المتداخلة التي تتباعد فلا استجابة لها. تتلامس الحافتان حين يكون المركزان على بعد ⁦r₁ + r₂⁩: انظر بماذا تُقارَن المسافة بينهما.</translation>
    </message>
    <message>
        <source>The circles answer where their centres meet</source>
        <translation>تستجيب الدائرتان حيث يلتقي مركزاهما</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when their centres were between %4 and %5 m apart.</source>
        <translation>مع ⁦r₁ = %1 m⁩ و⁦r₂ = %2 m⁩، واللقاء عند ⁦%3°⁩، استجابتا حين كانت المسافة بين مركزيهما بين ⁨%4⁩ و⁦%5 m⁩.</translation>
    </message>
    <message>
        <source>The test of contact acts as if a number stood for r₁ + r₂</source>
        <translation>يعمل اختبار التلامس كأن عددًا يقوم مقام ⁦r₁&#xa0;+&#xa0;r₂⁩</translation>
    </message>
    <message>
        <source>The circles answer before they touch</source>
        <translation>تستجيب الدائرتان قبل أن تتلامسا</translation>
    </message>
    <message>
        <source>The circles answer too late</source>
        <translation>تستجيب الدائرتان متأخرتين</translation>
    </message>
    <message>
        <source>A hit puts circle %1 somewhere else

When they touched it was put to %2 m, far from where it came from. Each circle goes back to its *own* old place: look at which one it gets.</source>
        <translation>يضع التصادم الدائرة ⁨%1⁩ في مكان آخر

عند التلامس وُضعت في ⁦%2 m⁩، بعيدًا عن المكان الذي جاءت منه. كل دائرة تعود إلى موضعها القديم *هي*: انظر أيّ موضع تأخذ.</translation>
    </message>
    <message>
        <source>Nothing happens when it is circle 2 that comes nearer</source>
        <translation>لا يحدث شيء حين تكون الدائرة 2 هي التي تقترب</translation>
    </message>
    <message>
        <source>Along the line of centres circle 1 had %1 m/s and circle 2 %2 m/s, so they came nearer with %3 m/s, and ran into each other; other meetings are answered. What counts is the velocity of one relative to the other.</source>
        <translation>كانت السرعة على خط المركزين ⁦%1 m/s⁩ للدائرة 1 و⁦%2 m/s⁩ للدائرة 2، فاقتربتا بسرعة ⁦%3 m/s⁩ وتداخلتا؛ أما اللقاءات الأخرى فيُستجاب لها. المهم هو سرعة إحداهما بالنسبة إلى الأخرى.</translation>
    </message>
    <message>
        <source>Circles that already part are hit again</source>
        <translation>دائرتان تفترقان بالفعل تُصدمان مرة أخرى</translation>
    </message>
    <message>
        <source>They overlapped and moved apart with %1 m/s; the next step turned them to %2 and %3 m/s.</source>
        <translation>كانتا متداخلتين وتتباعدان بسرعة ⁦%1 m/s⁩؛ فجعلت الخطوة التالية سرعتيهما ⁨%2⁩ و⁦%3 m/s⁩.</translation>
    </message>
    <message>
        <source>They moved apart with %1 m/s, with %4 m between their rims; the next step turned them to %2 and %3 m/s.</source>
        <translation>كانتا تتباعدان بسرعة ⁦%1 m/s⁩، وبين حافتيهما ⁦%4 m⁩؛ فجعلت الخطوة التالية سرعتيهما ⁨%2⁩ و⁦%3 m/s⁩.</translation>
    </message>
    <message>
        <source>Circles that move apart have had their hit: ask whether they come nearer.</source>
        <translation>الدائرتان المتباعدتان سبق أن تصادمتا: اسأل هل تتقاربان.</translation>
    </message>
    <message>
        <source>A run that begins so leaves them alone: look at what your program keeps from one step to the next.</source>
        <translation>والتشغيل الذي يبدأ هكذا يتركهما: انظر إلى ما يحفظه برنامجك من خطوة إلى التي تليها.</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>الدائرة %1</translation>
    </message>
    <message>
        <source>both circles</source>
        <translation>كلتا الدائرتين</translation>
    </message>
    <message>
        <source>all circles</source>
        <translation>كل الدوائر</translation>
    </message>
    <message>
        <source>the circles %1</source>
        <translation>الدوائر ⁧%1⁩</translation>
    </message>
    <message>
        <source>The velocity of %who changes although no force acts</source>
        <translation>تتغيّر سرعة %who مع أنّ أيّ قوّة لا تؤثّر</translation>
    </message>
    <message>
        <source>Without a force a velocity stays as it is: look for the line that changes it in free flight.</source>
        <translation>من دون قوّة تبقى السرعة على حالها: ابحث عن السطر الذي يغيّرها في الطيران الحرّ.</translation>
    </message>
    <message>
        <source>The same fault shows in this, too: %1.</source>
        <translation>ويظهر الخطأ نفسه في هذا أيضًا: ⁨%1⁩.</translation>
    </message>
    <message>
        <source>Line %1 sets a field `%2` of your own, which nothing reads: a circle has a `%3`.</source>
        <translation>يعيّن السطر ⁨%1⁩ حقلًا خاصًا بك `%2` لا يقرؤه شيء: للدائرة `%3`.</translation>
    </message>
    <message>
        <source>The whole velocities change hands and are turned round as well</source>
        <translation>تُتبادل السرعتان كاملتين وتُعكسان أيضًا</translation>
    </message>
    <message>
        <source>Both circles get their new part along the normal besides the old</source>
        <translation>تحصل الدائرتان على مركّبتهما الجديدة على طول الناظم فوق القديمة</translation>
    </message>
    <message>
        <source>Circle 1 gets its new part along the normal besides the old</source>
        <translation>تحصل الدائرة 1 على مركّبتها الجديدة على طول الناظم فوق القديمة</translation>
    </message>
    <message>
        <source>Circle 2 gets its new part along the normal besides the old</source>
        <translation>تحصل الدائرة 2 على مركّبتها الجديدة على طول الناظم فوق القديمة</translation>
    </message>
    <message>
        <source>A hit gives a new part along the line of centres in place of the old one: look at what the new part is added to.</source>
        <translation>يعطي التصادم مركّبة جديدة على طول خطّ المركزين بدلًا من القديمة: انظر إلى ما تُضاف إليه المركّبة الجديدة.</translation>
    </message>
    <message>
        <source>The circles answer each other although they are far apart</source>
        <translation>تستجيب الدائرتان إحداهما للأخرى مع أنّهما متباعدتان</translation>
    </message>
    <message>
        <source>Started with %1 and %2 m/s, far from each other, they have %3 and %4 m/s one step of %5 s later; where circle %6 starts at %7 m, circle %8 keeps its velocity. Look at how your program tests whether they touch.</source>
        <translation>أُطلقتا بسرعة ⁨%1⁩ و⁨%2⁩ m/s متباعدتين، فصارت سرعتاهما ⁨%3⁩ و⁨%4⁩ m/s بعد خطوة مدّتها ⁨%5⁩ s؛ وحيث تبدأ الدائرة ⁨%6⁩ عند ⁨%7⁩ m تحتفظ الدائرة ⁨%8⁩ بسرعتها. انظر كيف يختبر برنامجك ما إذا كانتا تتلامسان.</translation>
    </message>
    <message>
        <source>Started with %1 and %2 m/s, far from each other, they have %3 and %4 m/s one step of %5 s later: the velocities change against each other, as in a hit. Look at how your program tests whether they touch.</source>
        <translation>أُطلقتا بسرعة ⁨%1⁩ و⁨%2⁩ m/s متباعدتين، فصارت سرعتاهما ⁨%3⁩ و⁨%4⁩ m/s بعد خطوة مدّتها ⁨%5⁩ s: تتغيّر السرعتان إحداهما عكس الأخرى كما في تصادم. انظر كيف يختبر برنامجك ما إذا كانتا تتلامسان.</translation>
    </message>
    <message>
        <source>A number stands for gravity in the motion of %who</source>
        <translation>يقوم عدد مقام الجاذبية في حركة %who</translation>
    </message>
    <message>
        <source>Gravity pulls %who in a wrong direction</source>
        <translation>تشد الجاذبية %who في اتجاه خاطئ</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the velocity changes by %2 m/s in a step of %3 s; it should change by %4 m/s.</source>
        <translation>تحت الجاذبية ⁦%1 m/s²⁩ تتغير السرعة بمقدار ⁦%2 m/s⁩ في خطوة مدتها ⁦%3 s⁩؛ ويجب أن تتغير بمقدار ⁦%4 m/s⁩.</translation>
    </message>
    <message>
        <source>Gravity moves %who at once and changes no velocity</source>
        <translation>تحرّك الجاذبية %who مباشرة ولا تغيّر أي سرعة</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² a circle at rest is %2 m away after a step of %3 s, and its velocity is still 0. Gravity is an acceleration: it changes the velocity, and that moves the circle.</source>
        <translation>تحت الجاذبية ⁦%1 m/s²⁩ تكون دائرة ساكنة على بعد ⁦%2 m⁩ بعد خطوة مدتها ⁦%3 s⁩، وسرعتها لا تزال 0. الجاذبية تسارع: تغيّر السرعة، والسرعة تحرّك الدائرة.</translation>
    </message>
    <message>
        <source>Gravity acts on %who for a whole second in every step</source>
        <translation>تؤثر الجاذبية في %who ثانية كاملة في كل خطوة</translation>
    </message>
    <message>
        <source>An acceleration says what a second changes; a step lasts only Δt. Compare the units on both sides.</source>
        <translation>التسارع يقول ما تغيّره ثانية كاملة؛ والخطوة لا تدوم إلا Δt. قارن الوحدات في الطرفين.</translation>
    </message>
    <message>
        <source>Gravity on %who is multiplied by the timestep twice</source>
        <translation>تُضرب الجاذبية على %who في الخطوة الزمنية مرتين</translation>
    </message>
    <message>
        <source>Count how often the timestep stands in the line that changes the velocity.</source>
        <translation>عُدّ كم مرة ترد الخطوة الزمنية في السطر الذي يغيّر السرعة.</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep in the fall of %who</source>
        <translation>يقوم عدد ثابت مقام الخطوة الزمنية في سقوط %who</translation>
    </message>
    <message>
        <source>Look at the signs.</source>
        <translation>انظر إلى الإشارات.</translation>
    </message>
    <message>
        <source>Gravity acts on %who twice as strongly</source>
        <translation>تؤثر الجاذبية في %who بضعف شدّتها</translation>
    </message>
    <message>
        <source>Count the lines of a step that change the velocity, and look at their factors.</source>
        <translation>عُدّ أسطر الخطوة التي تغيّر السرعة، وانظر إلى عواملها.</translation>
    </message>
    <message>
        <source>The velocity of %who gets only half of gravity</source>
        <translation>لا تنال سرعة %who إلا نصف الجاذبية</translation>
    </message>
    <message>
        <source>Look at the factors in the line that changes the velocity.</source>
        <translation>انظر إلى العوامل في السطر الذي يغيّر السرعة.</translation>
    </message>
    <message>
        <source>The fall of %who is not that of the gravity in the scene</source>
        <translation>لا تسقط %who بجاذبية المشهد</translation>
    </message>
    <message>
        <source>In your own scene gravity is %1 m/s², and the velocity changes by %2 m/s in a second. A copy of gravity keeps the value of the moment when it was made: before or after `on_load` has set it?</source>
        <translation>في مشهدك الجاذبية ⁦%1 m/s²⁩، وتتغير السرعة بمقدار ⁦%2 m/s⁩ في الثانية. نسخةٌ من الجاذبية تحتفظ بقيمة اللحظة التي صُنعت فيها: أقبل أن تضبطها ⁦`on_load`⁩ أم بعده؟</translation>
    </message>
    <message>
        <source>In your own scene the first step changes the velocity of %who</source>
        <translation>في مشهدك تغيّر الخطوة الأولى سرعة %who</translation>
    </message>
    <message>
        <source>The motion of %who is no known method</source>
        <translation>لا تتحرك %who بطريقة معروفة</translation>
    </message>
    <message>
        <source>The motion of %who is %1, not %2</source>
        <translation>تتحرك %who بطريقة ⁨%1⁩، لا بطريقة ⁨%2⁩</translation>
    </message>
    <message>
        <source>The motion of %who is no known method; %1 is asked for</source>
        <translation>لا تتحرك %who بطريقة معروفة؛ المطلوب ⁨%1⁩</translation>
    </message>
    <message>
        <source>Every step puts %who where circle %1 is</source>
        <translation>تضع كل خطوة %who حيث الدائرة ⁨%1⁩</translation>
    </message>
    <message>
        <source>The velocity of %who is set anew in every step</source>
        <translation>تُضبط سرعة %who من جديد في كل خطوة</translation>
    </message>
    <message>
        <source>The x of the velocity of %who is 0 after every step</source>
        <translation>المركّبة x لسرعة %who صفر بعد كل خطوة</translation>
    </message>
    <message>
        <source>The x of the velocity of %who is set anew in every step</source>
        <translation>تُضبط المركّبة x لسرعة %who من جديد في كل خطوة</translation>
    </message>
    <message>
        <source>The y of the velocity of %who is 0 after every step</source>
        <translation>المركّبة y لسرعة %who صفر بعد كل خطوة</translation>
    </message>
    <message>
        <source>The y of the velocity of %who is set anew in every step</source>
        <translation>تُضبط المركّبة y لسرعة %who من جديد في كل خطوة</translation>
    </message>
    <message>
        <source>The velocity of circle %1 moves %who</source>
        <translation>سرعة الدائرة ⁨%1⁩ هي التي تحرّك %who</translation>
    </message>
    <message>
        <source>The velocity of %who at the start is not taken over</source>
        <translation>لا تُؤخذ سرعة البداية في %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and so it has from every other start tried; later steps go on from that.</source>
        <translation>بدأت بسرعة %1 m/s فصار لها %2 m/s بعد خطوة واحدة، وكذلك من كل بداية أخرى جُرّبت؛ والخطوات التالية تواصل من ذلك.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later; one part is the same from every other start tried, and later steps go on from that.</source>
        <translation>بدأت بسرعة %1 m/s فصار لها %2 m/s بعد خطوة واحدة؛ إحدى المركّبتين هي نفسها من كل بداية أخرى جُرّبت، والخطوات التالية تواصل من ذلك.</translation>
    </message>
    <message>
        <source>A run begins with the velocity that the circle has then: look at which one your program begins with instead.</source>
        <translation>يبدأ التشغيل بالسرعة التي للدائرة عندئذ: انظر بأي سرعة يبدأ برنامجك بدلًا منها.</translation>
    </message>
    <message>
        <source>The place of %who at the start is not taken over</source>
        <translation>لا يُؤخذ موضع البداية في %who</translation>
    </message>
    <message>
        <source>Started at rest at two places, it is at one and the same place two steps later; the second step goes on from where the first one ends. A run begins where the circle is then: look at which place your program begins with instead.</source>
        <translation>بدأت ساكنة من موضعين فصارت بعد خطوتين في موضع واحد بعينه؛ والخطوة الثانية تواصل من حيث تنتهي الأولى. يبدأ التشغيل حيث تكون الدائرة عندئذ: انظر بأي موضع يبدأ برنامجك بدلًا منه.</translation>
    </message>
    <message>
        <source>A step of %who does %1 times what it should</source>
        <translation>تفعل الخطوة %1 أضعاف ما ينبغي، في %who</translation>
    </message>
    <message>
        <source>x and y of the velocity of %who are exchanged</source>
        <translation>تبادلت مركّبتا السرعة x وy مكانيهما في %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the first step of %3 s and has %4 m/s after it. Each part of the velocity goes on from itself: look at the line that writes it down.</source>
        <translation>بدأت بسرعة %1 m/s فقطعت %2 m في الخطوة الأولى ومدتها %3 s وصار لها بعدها %4 m/s. كل مركّبة من السرعة تواصل من نفسها: انظر السطر الذي يكتبها.</translation>
    </message>
    <message>
        <source>The velocity of %who at the start is not taken over whole</source>
        <translation>لا تُؤخذ سرعة البداية كاملة في %who</translation>
    </message>
    <message>
        <source>The new place of %who does not depend on the old one</source>
        <translation>موضع %who الجديد لا يتوقف على القديم</translation>
    </message>
    <message>
        <source>The old place of %who is multiplied, too</source>
        <translation>موضع %who القديم يُضرب أيضًا</translation>
    </message>
    <message>
        <source>Two that start 1 m apart, at rest, are %1 m apart one step of %2 s later. The old position is kept as it is; the way v Δt is added to it: look at the brackets.</source>
        <translation>دائرتان تبدآن ساكنتين وبينهما ⁦1 m⁩ تصير المسافة بينهما ⁦%1 m⁩ بعد خطوة مدتها ⁦%2 s⁩. يبقى الموضع القديم كما هو؛ وتُضاف إليه المسافة ⁦v&#xa0;Δt⁩: انظر إلى الأقواس.</translation>
    </message>
    <message>
        <source> Both parts of the position must change, each by its own part of the velocity.</source>
        <translation> يجب أن تتغير كلتا مركّبتي الموضع، كلٌّ بمركّبة السرعة التي تخصها.</translation>
    </message>
    <message>
        <source>Each part of the position changes by its own part of the velocity.</source>
        <translation>كل مركّبة من الموضع تتغير بمركّبة السرعة التي تخصها.</translation>
    </message>
    <message>
        <source>The x part of the velocity moves %who in y</source>
        <translation>المركّبة x للسرعة تحرّك %who في y</translation>
    </message>
    <message>
        <source>The y part of the velocity moves %who in x</source>
        <translation>المركّبة y للسرعة تحرّك %who في x</translation>
    </message>
    <message>
        <source>x and y of the velocity are exchanged in the way of %who</source>
        <translation>تبادلت مركّبتا السرعة x وy مكانيهما حيث تُحرَّك %who</translation>
    </message>
    <message>
        <source>The way of %who in a step is not v Δt</source>
        <translation>مسافة %who في الخطوة ليست ⁦v&#xa0;Δt⁩</translation>
    </message>
    <message>
        <source>The way of %who is not multiplied by the timestep</source>
        <translation>مسافة %who لا تُضرب في الخطوة الزمنية</translation>
    </message>
    <message>
        <source>A velocity says how far it gets in a whole second; a step lasts only Δt.</source>
        <translation>السرعة تقول كم تُقطع في ثانية كاملة؛ والخطوة لا تدوم إلا Δt.</translation>
    </message>
    <message>
        <source>The way of %who is multiplied by the timestep twice</source>
        <translation>مسافة %who تُضرب في الخطوة الزمنية مرتين</translation>
    </message>
    <message>
        <source>Count how often the timestep stands in the line that moves it.</source>
        <translation>عُدّ كم مرة ترد الخطوة الزمنية في السطر الذي يحرّك الدائرة.</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep in the way of %who</source>
        <translation>يقوم عدد ثابت مقام الخطوة الزمنية في مسافة %who</translation>
    </message>
    <message>
        <source>Look at the line that changes the position.</source>
        <translation>انظر إلى السطر الذي يغيّر الموضع.</translation>
    </message>
    <message>
        <source>The way of %who is subtracted instead of added</source>
        <translation>مسافة %who تُطرح بدل أن تُضاف</translation>
    </message>
    <message>
        <source>Look at the sign in the line that moves it.</source>
        <translation>انظر إلى الإشارة في السطر الذي يحرّك الدائرة.</translation>
    </message>
    <message>
        <source>Every step moves %who twice as far</source>
        <translation>كل خطوة تحرّك %who ضعف المسافة</translation>
    </message>
    <message>
        <source>Look at what your program keeps from one step to the next, and at what it has of that before the first.</source>
        <translation>انظر إلى ما يحتفظ به برنامجك من خطوة إلى التي تليها، وإلى ما لديه منه قبل الأولى.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the first step of %3 s; made as the second is, that step goes %4 m.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ تقدمت ⁦%2 m⁩ في الخطوة الأولى ومدتها ⁦%3 s⁩؛ ولو حُسبت كالثانية لتقدمت ⁦%4 m⁩.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s after the first step of %3 s; made as the second is, that step gives it %4 m/s.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ كانت سرعتها ⁦%2 m/s⁩ بعد الخطوة الأولى ومدتها ⁦%3 s⁩؛ ولو حُسبت كالثانية لكانت ⁦%4 m/s⁩.</translation>
    </message>
    <message>
        <source>The first step of %who is made in another way</source>
        <translation>الخطوة الأولى من %who تُحسب بطريقة أخرى</translation>
    </message>
    <message>
        <source>Count the lines that change the position in a step without a hit, and look at their factors.</source>
        <translation>عُدّ الأسطر التي تغيّر الموضع في خطوة بلا تصادم، وانظر إلى عواملها.</translation>
    </message>
    <message>
        <source>The way of %who in a step is %1 times v Δt</source>
        <translation>مسافة %who في الخطوة تساوي ⁦v&#xa0;Δt⁩ مضروبًا في ⁨%1⁩</translation>
    </message>
    <message>
        <source>Look at the factors in the line that moves it.</source>
        <translation>انظر إلى العوامل في السطر الذي يحرّك الدائرة.</translation>
    </message>
    <message>
        <source>The place of %who acts on its velocity otherwise than asked</source>
        <translation>موضع %who يؤثر في سرعتها على غير المطلوب</translation>
    </message>
    <message>
        <source>Something slows %who down on the way</source>
        <translation>شيء ما يبطئ %who في الطريق</translation>
    </message>
    <message>
        <source>Something makes %who faster on the way</source>
        <translation>شيء ما يسرّع %who في الطريق</translation>
    </message>
    <message>
        <source>Nothing slows %who down on the way</source>
        <translation>لا شيء يبطئ %who في الطريق</translation>
    </message>
    <message>
        <source>Nothing makes %who faster on the way</source>
        <translation>لا شيء يسرّع %who في الطريق</translation>
    </message>
    <message>
        <source>What should slow %who down makes it faster</source>
        <translation>ما ينبغي أن يبطئ %who يسرّعها</translation>
    </message>
    <message>
        <source>What should make %who faster slows it down</source>
        <translation>ما ينبغي أن يسرّع %who يبطئها</translation>
    </message>
    <message>
        <source>What acts on the velocity of %who is %1 times as strong as it should be</source>
        <translation>ما يؤثر في سرعة %who يساوي ما يجب مضروبًا في ⁨%1⁩</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), the change of v₁ was %5 times that of v₂; m₂/m₁ = %6 is right.</source>
        <translation>مع ⁦r₁ = %1⁩ و⁦r₂ = %2 m⁩، و⁦ρ₁ = %3⁩ و⁦ρ₂ = %4⁩ (و⁦e = %7⁩)، كان تغير v₁ يساوي تغير v₂ مضروبًا في ⁨%5⁩؛ الصواب ⁦m₂/m₁ = %6⁩.</translation>
    </message>
    <message>
        <source>Where the masses differ, only circle %1 leaves as it should</source>
        <translation>حين تختلف الكتلتان تغادر الدائرة ⁨%1⁩ وحدها كما يجب</translation>
    </message>
    <message>
        <source>The two masses are not worked out in the same way</source>
        <translation>لا تُحسب الكتلتان بالطريقة نفسها</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with another density that both have %2 times. Compare the lines for the two masses.</source>
        <translation>دائرتان متساويتان في نصف القطر والكثافة تستجيبان كأن كتلة الدائرة 2 تساوي كتلة الدائرة 1 مضروبةً في ⁨%1⁩، ومع كثافة أخرى مشتركة مضروبةً في ⁨%2⁩. قارن بين سطري الكتلتين.</translation>
    </message>
    <message>
        <source>Here two circles of the same mass meet. </source>
        <translation>هنا تلتقي دائرتان متساويتا الكتلة. </translation>
    </message>
    <message>
        <source>Here two circles of the same mass meet, with e = %1. </source>
        <translation>هنا تلتقي دائرتان متساويتا الكتلة، مع ⁨e = %1⁩. </translation>
    </message>
    <message>
        <source>Both velocities change equally much, whatever the masses are</source>
        <translation>تتغيّر السرعتان بالمقدار نفسه مهما كانت الكتلتان</translation>
    </message>
    <message>
        <source>The heavier of two circles changes its velocity less. Look at where the masses of both enter your answer.</source>
        <translation>الدائرة الأثقل تتغيّر سرعتها أقل. انظر أين تدخل كتلتا الدائرتين في استجابتك.</translation>
    </message>
    <message>
        <source>The heavier circle is pushed away faster</source>
        <translation>الدائرة الأثقل تُدفع أسرع</translation>
    </message>
    <message>
        <source>The masses do not only change places. Look at every place where one enters your answer.</source>
        <translation>ليس الأمر تبادل الكتلتين مكانيهما فحسب. انظر إلى كل موضع تدخل فيه كتلة في استجابتك.</translation>
    </message>
    <message>
        <source>The hits do not depend on the radii</source>
        <translation>التصادمات لا تتوقف على نصفي القطرين</translation>
    </message>
    <message>
        <source>The mass grows with r to the power of %1, not %2</source>
        <translation>تنمو الكتلة مع r أُسّ ⁨%1⁩، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>The masses do not follow the radii as those of balls do</source>
        <translation>الكتلتان لا تتبعان نصفي القطرين كما تفعل كتل الكرات</translation>
    </message>
    <message>
        <source>A ball that is twice as wide is also twice as high and as deep: its mass grows with r³.</source>
        <translation>الكرة التي عرضها الضعف ارتفاعها وعمقها الضعف أيضًا: كتلتها تنمو مع r³.</translation>
    </message>
    <message>
        <source>The hits do not depend on the densities</source>
        <translation>التصادمات لا تتوقف على الكثافتين</translation>
    </message>
    <message>
        <source>The mass grows with the density to the power of %1, not %2</source>
        <translation>تنمو الكتلة مع الكثافة أُسّ ⁨%1⁩، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>The masses do not follow the densities</source>
        <translation>الكتلتان لا تتبعان الكثافتين</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %5) they came nearer with u = %6 m/s along the line of centres.</source>
        <translation>مع ⁦r₁ = %1⁩ و⁦r₂ = %2 m⁩ و⁦ρ₁ = %3⁩ و⁦ρ₂ = %4⁩ (⁦e = %5⁩) كانتا تتقاربان بسرعة ⁦u = %6 m/s⁩ على خط المركزين.</translation>
    </message>
    <message>
        <source>Circle 1 changed its velocity by %1 m/s and circle 2 by %2, together %3 m/s; (1 + e) u = %4 m/s is right. However heavy they are, the share of circle 1 is m₂/(m₁ + m₂) and that of circle 2 m₁/(m₁ + m₂).</source>
        <translation>غيّرت الدائرة 1 سرعتها بمقدار ⁦%1 m/s⁩ والدائرة 2 بمقدار ⁨%2⁩، ومعًا ⁦%3 m/s⁩؛ الصواب ⁦(1 + e) u = %4 m/s⁩. ومهما كان ثقلهما فنصيب الدائرة 1 هو ⁦m₂/(m₁ + m₂)⁩ ونصيب الدائرة 2 هو ⁦m₁/(m₁ + m₂)⁩.</translation>
    </message>
    <message>
        <source>Some hits drive the circles towards each other</source>
        <translation>بعض التصادمات تدفع الدائرتين إحداهما نحو الأخرى</translation>
    </message>
    <message>
        <source>Along it, from 1 to 2, the velocity of circle 1 changed by %1 m/s and that of circle 2 by %2 m/s, so that they come nearer still faster. A hit takes (1 + e) u = %3 m/s of that, and each circle changes by its share: circle 1 by m₂/(m₁ + m₂) and circle 2 by m₁/(m₁ + m₂) of it.</source>
        <translation>على هذا الخط، من 1 إلى 2، تغيّرت سرعة الدائرة 1 بمقدار ⁦%1 m/s⁩ وسرعة الدائرة 2 بمقدار ⁦%2 m/s⁩، فتقتربان أسرع من قبل. التصادم ينقص من ذلك ⁦(1 + e) u = %3 m/s⁩، ولكل دائرة نصيبها منه: الدائرة 1 بمقدار ⁦m₂/(m₁ + m₂)⁩ والدائرة 2 بمقدار ⁦m₁/(m₁ + m₂)⁩.</translation>
    </message>
    <message>
        <source>The shares of the two circles do not add up to 1</source>
        <translation>لا يساوي مجموع نصيبي الدائرتين 1</translation>
    </message>
    <message>
        <source>Mass is density times volume, for each circle its own.</source>
        <translation>الكتلة هي الكثافة مضروبةً في الحجم، لكل دائرة بكثافتها وحجمها.</translation>
    </message>
    <message>
        <source>With e = %1: </source>
        <translation>مع ⁦e = %1⁩: </translation>
    </message>
    <message>
        <source>e also shortens the part of circle %1 across the line of centres</source>
        <translation>المعامل e يقصّر أيضًا مركّبة الدائرة ⁨%1⁩ المعامدة لخط المركزين</translation>
    </message>
    <message>
        <source>Nothing pushes there: it stays as it was.</source>
        <translation>لا شيء يدفع هناك: فهي تبقى كما كانت.</translation>
    </message>
    <message>
        <source>e multiplies the whole velocities after the hit</source>
        <translation>تُضرب السرعتان كاملتين في e بعد التصادم</translation>
    </message>
    <message>
        <source>e belongs to the rebound along the line of centres alone; the total momentum stays.</source>
        <translation>المعامل e يخص الارتداد على خط المركزين وحده؛ وكمية الحركة الكلية تبقى.</translation>
    </message>
    <message>
        <source>e also shortens the parts across the line of centres</source>
        <translation>المعامل e يقصّر أيضًا المركّبتين المعامدتين لخط المركزين</translation>
    </message>
    <message>
        <source>Nothing pushes there: they stay as they were.</source>
        <translation>لا شيء يدفع هناك: فهما تبقيان كما كانتا.</translation>
    </message>
    <message>
        <source>e changes nothing in the hits tried</source>
        <translation>لا يغيّر المعامل e شيئًا في التصادمات المجرَّبة</translation>
    </message>
    <message>
        <source>e is squared in the hit of two circles</source>
        <translation>المعامل e يُربَّع في تصادم الدائرتين</translation>
    </message>
    <message>
        <source>The root of e is used in the hit of two circles</source>
        <translation>يُستعمل جذر e في تصادم الدائرتين</translation>
    </message>
    <message>
        <source>e works the wrong way round: the factor is 2 − e, not 1 + e</source>
        <translation>المعامل e يعمل بالعكس: العامل ⁦2 − e⁩، لا ⁦1 + e⁩</translation>
    </message>
    <message>
        <source>The push is multiplied by 2 e instead of 1 + e</source>
        <translation>الدفع مضروب في ⁦2 e⁩ بدلًا من ⁦1 + e⁩</translation>
    </message>
    <message>
        <source>The push is multiplied by e instead of 1 + e</source>
        <translation>الدفع مضروب في e بدلًا من ⁦1 + e⁩</translation>
    </message>
    <message>
        <source>The push is multiplied by e (1 + e) instead of 1 + e</source>
        <translation>الدفع مضروب في ⁦e (1 + e)⁩ بدلًا من ⁦1 + e⁩</translation>
    </message>
    <message>
        <source>The rebound is divided by e</source>
        <translation>الارتداد مقسوم على e</translation>
    </message>
    <message>
        <source>The sign of e is wrong in the hit of two circles</source>
        <translation>إشارة e خاطئة في تصادم الدائرتين</translation>
    </message>
    <message>
        <source>Of two equal circles only circle %1 leaves as it should</source>
        <translation>من دائرتين متساويتين تغادر الدائرة ⁨%1⁩ وحدها كما يجب</translation>
    </message>
    <message>
        <source>e does not act on the rebound as it should</source>
        <translation>المعامل e لا يؤثر في الارتداد كما يجب</translation>
    </message>
    <message>
        <source>A number stands for e in the hit of two circles</source>
        <translation>يقوم عدد مقام e في تصادم الدائرتين</translation>
    </message>
    <message>
        <source>Numbers stand for e in the hit of two circles</source>
        <translation>تقوم أعداد مقام e في تصادم الدائرتين</translation>
    </message>
    <message>
        <source>A hit acts on both circles.</source>
        <translation>التصادم يؤثر في كلتا الدائرتين.</translation>
    </message>
    <message>
        <source>Nobody holds the other circle as a wall is held: look at what each circle gets of the other.</source>
        <translation>لا أحد يمسك الدائرة الأخرى كما يُمسك الجدار: انظر ماذا تنال كل دائرة من الأخرى.</translation>
    </message>
    <message>
        <source>A hit leaves circle 2 as it was</source>
        <translation>يترك التصادم الدائرة 2 كما كانت</translation>
    </message>
    <message>
        <source>A hit leaves circle 1 as it was</source>
        <translation>يترك التصادم الدائرة 1 كما كانت</translation>
    </message>
    <message>
        <source>A hit stops both circles</source>
        <translation>يوقف التصادم كلتا الدائرتين</translation>
    </message>
    <message>
        <source>That was right in the step that only looked for the contact.</source>
        <translation>كان ذلك صحيحًا في المرحلة التي لم تبحث إلا عن التلامس.</translation>
    </message>
    <message>
        <source>A hit stops circle 1 and leaves circle 2 as it was</source>
        <translation>يوقف التصادم الدائرة 1 ويترك الدائرة 2 كما كانت</translation>
    </message>
    <message>
        <source>A hit stops circle 2 and leaves circle 1 as it was</source>
        <translation>يوقف التصادم الدائرة 2 ويترك الدائرة 1 كما كانت</translation>
    </message>
    <message>
        <source>Each circle is turned back on its own way</source>
        <translation>تُردّ كل دائرة على طريقها نفسه</translation>
    </message>
    <message>
        <source>Each circle bounces as off a wall</source>
        <translation>ترتد كل دائرة كأنها عن جدار</translation>
    </message>
    <message>
        <source>Circle 1 bounces as off a wall</source>
        <translation>ترتد الدائرة 1 كأنها عن جدار</translation>
    </message>
    <message>
        <source>Circle 2 bounces as off a wall</source>
        <translation>ترتد الدائرة 2 كأنها عن جدار</translation>
    </message>
    <message>
        <source>Circle 1 bounces as off a wall, and circle 2 stays as it was</source>
        <translation>ترتد الدائرة 1 كأنها عن جدار، وتبقى الدائرة 2 كما كانت</translation>
    </message>
    <message>
        <source>Circle 2 bounces as off a wall, and circle 1 stays as it was</source>
        <translation>ترتد الدائرة 2 كأنها عن جدار، وتبقى الدائرة 1 كما كانت</translation>
    </message>
    <message>
        <source>The parts across the line of centres turn round, not those along it</source>
        <translation>تنعكس المركّبات المعامدة لخط المركزين، لا الموازية له</translation>
    </message>
    <message>
        <source>The push acts along the line of centres.</source>
        <translation>يؤثر الدفع على خط المركزين.</translation>
    </message>
    <message>
        <source>A smooth circle pushes along the line of centres only; each keeps its own part across.</source>
        <translation>الدائرة الملساء لا تدفع إلا على خط المركزين؛ وكلٌّ تحتفظ بمركّبتها المعامدة.</translation>
    </message>
    <message>
        <source>Both new velocities come from those *before* the hit: look at which lines read a velocity that has been written.</source>
        <translation>السرعتان الجديدتان كلتاهما تأتيان من السرعتين *قبل* التصادم: انظر أيّ الأسطر يقرأ سرعة قد كُتبت.</translation>
    </message>
    <message>
        <source>The parts across change hands, and those along the normal stay</source>
        <translation>تتبادل الدائرتان المركّبتين المعامدتين، وتبقى المركّبتان على الناظم</translation>
    </message>
    <message>
        <source>The parts across the normal are lost</source>
        <translation>تضيع المركّبتان المعامدتان للناظم</translation>
    </message>
    <message>
        <source>Both circles leave with the velocity of circle 2</source>
        <translation>تغادر كلتا الدائرتين بسرعة الدائرة 2</translation>
    </message>
    <message>
        <source>Both circles leave with the velocity of circle 1</source>
        <translation>تغادر كلتا الدائرتين بسرعة الدائرة 1</translation>
    </message>
    <message>
        <source>The velocity of circle 2 is worked out from what circle 1 has become</source>
        <translation>تُحسب سرعة الدائرة 2 مما صارت إليه الدائرة 1</translation>
    </message>
    <message>
        <source>The velocity of circle 1 is worked out from what circle 2 has become</source>
        <translation>تُحسب سرعة الدائرة 1 مما صارت إليه الدائرة 2</translation>
    </message>
    <message>
        <source>After a hit both circles have the same velocity</source>
        <translation>بعد التصادم تكون للدائرتين السرعة نفسها</translation>
    </message>
    <message>
        <source>The part of circle 2 along the normal is forgotten</source>
        <translation>نُسيت مركّبة الدائرة 2 على الناظم</translation>
    </message>
    <message>
        <source>Circle 1 gives its part away and gets nothing for it.</source>
        <translation>تعطي الدائرة 1 مركّبتها ولا تنال شيئًا مقابلها.</translation>
    </message>
    <message>
        <source>The part of circle 1 along the normal is forgotten</source>
        <translation>نُسيت مركّبة الدائرة 1 على الناظم</translation>
    </message>
    <message>
        <source>Circle 2 gives its part away and gets nothing for it.</source>
        <translation>تعطي الدائرة 2 مركّبتها ولا تنال شيئًا مقابلها.</translation>
    </message>
    <message>
        <source>Circle 1 keeps the part that it hands over</source>
        <translation>تحتفظ الدائرة 1 بالمركّبة التي تسلّمها</translation>
    </message>
    <message>
        <source>What circle 2 gets, circle 1 must lose.</source>
        <translation>ما تناله الدائرة 2 يجب أن تفقده الدائرة 1.</translation>
    </message>
    <message>
        <source>The parts along the normal change hands and are turned round as well</source>
        <translation>تنتقل المركّبتان على الناظم وتنعكسان أيضًا</translation>
    </message>
    <message>
        <source>The exchange alone is the whole answer.</source>
        <translation>التبادل وحده هو الاستجابة كلها.</translation>
    </message>
    <message>
        <source>The push on circle 1 has the wrong sign</source>
        <translation>الدفع على الدائرة 1 له إشارة خاطئة</translation>
    </message>
    <message>
        <source>It gains the part that it should lose.</source>
        <translation>تكسب المركّبة التي يجب أن تفقدها.</translation>
    </message>
    <message>
        <source>The push on circle 2 has the wrong sign</source>
        <translation>الدفع على الدائرة 2 له إشارة خاطئة</translation>
    </message>
    <message>
        <source>It loses the part that it should gain.</source>
        <translation>تفقد المركّبة التي يجب أن تكسبها.</translation>
    </message>
    <message>
        <source>Both pushes have the wrong sign</source>
        <translation>كلا الدفعين له إشارة خاطئة</translation>
    </message>
    <message>
        <source>The circles are drawn into each other.</source>
        <translation>تُجذب كلٌّ من الدائرتين إلى داخل الأخرى.</translation>
    </message>
    <message>
        <source>A direction has length 1: divide it by its own length, else its length comes into the push, and twice.</source>
        <translation>للاتجاه طول 1: اقسمه على طوله هو، وإلا دخل طوله في الدفع، ومرتين.</translation>
    </message>
    <message>
        <source>The push acts along the line from centre to centre.</source>
        <translation>يؤثر الدفع على الخط من مركز إلى مركز.</translation>
    </message>
    <message>
        <source>The normal does not have length 1</source>
        <translation>طول الناظم ليس 1</translation>
    </message>
    <message>
        <source>The perpendicular of the line of centres is taken for the normal</source>
        <translation>أُخذ الناظم على خط المركزين ناظمًا</translation>
    </message>
    <message>
        <source>The parts x and y of the normal are exchanged</source>
        <translation>تبادلت مركّبتا الناظم x وy مكانيهما</translation>
    </message>
    <message>
        <source>The normal is mirrored: the sign of its y is wrong</source>
        <translation>الناظم معكوس كما في مرآة: إشارة y فيه خاطئة</translation>
    </message>
    <message>
        <source>The push acts along the velocity of circle 1</source>
        <translation>يؤثر الدفع على امتداد سرعة الدائرة 1</translation>
    </message>
    <message>
        <source>The x parts change hands, not those along the line of centres</source>
        <translation>تتبادل الدائرتان مركّبتي x، لا اللتين على خط المركزين</translation>
    </message>
    <message>
        <source>The y parts change hands, not those along the line of centres</source>
        <translation>تتبادل الدائرتان مركّبتي y، لا اللتين على خط المركزين</translation>
    </message>
    <message>
        <source>The new velocities are turned back by the wrong angle</source>
        <translation>يُعكس تدوير السرعتين الجديدتين بزاوية خاطئة</translation>
    </message>
    <message>
        <source>Who turns by −φ before must turn by +φ afterwards.</source>
        <translation>من دوّر قبل الحساب بمقدار ⁦−φ⁩ يجب أن يدوّر بعده بمقدار ⁦+φ⁩.</translation>
    </message>
    <message>
        <source>The new velocities are not turned back</source>
        <translation>لا يُعكس تدوير السرعتين الجديدتين</translation>
    </message>
    <message>
        <source>They are still taken apart along the line of centres: put them together again.</source>
        <translation>لا تزالان محلَّلتين على خط المركزين: أعد تركيبهما.</translation>
    </message>
    <message>
        <source>The parts across the line of centres are changed</source>
        <translation>تتغير المركّبات المعامدة لخط المركزين</translation>
    </message>
    <message>
        <source>A smooth circle pushes along the line of centres only.</source>
        <translation>الدائرة الملساء لا تدفع إلا على خط المركزين.</translation>
    </message>
    <message>
        <source>The two pushes are not equal and opposite</source>
        <translation>الدفعان ليسا متساويين متعاكسين</translation>
    </message>
    <message>
        <source>What one circle of the same mass gains, the other loses: else the total momentum changes.</source>
        <translation>ما تكسبه دائرة تفقده الأخرى ذات الكتلة نفسها: وإلا تغيرت كمية الحركة الكلية.</translation>
    </message>
    <message>
        <source>The push is not along the line of centres</source>
        <translation>لا يقع الدفع على خط المركزين</translation>
    </message>
    <message>
        <source>The parts across it must stay as they were.</source>
        <translation>المركّبات المعامدة له يجب أن تبقى كما كانت.</translation>
    </message>
    <message>
        <source>The push has the wrong size</source>
        <translation>مقدار الدفع خاطئ</translation>
    </message>
    <message>
        <source>In meetings with a timestep of %1 s it was between %2 and %3 times as large as it should be.</source>
        <translation>في لقاءات بخطوة زمنية قدرها ⁦%1 s⁩ كان بين ⁨%2⁩ و⁨%3⁩ ضعفًا مما ينبغي أن يكون.</translation>
    </message>
    <message>
        <source>In your own scene the circles answer as if they had other masses</source>
        <translation>في مشهدك تستجيب الدائرتان كأن لهما كتلتين أخريين</translation>
    </message>
    <message>
        <source>There circle 2 answers as if it were %1 times as heavy as circle 1; with its radii %2 and %3 m and densities %4 and %5 it is %6 times. In other scenes the masses come out right.</source>
        <translation>فيه تستجيب الدائرتان كأن كتلة الدائرة 2 تساوي كتلة الدائرة 1 مضروبةً في ⁨%1⁩؛ ومع نصفي القطرين ⁨%2⁩ و⁦%3 m⁩ والكثافتين ⁨%4⁩ و⁨%5⁩ فالعامل ⁨%6⁩. في المشاهد الأخرى تصحّ الكتلتان.</translation>
    </message>
    <message>
        <source>So it is with radii or densities from before `on_load`: a mass that is worked out before they are set keeps the old value. Look at the order there, and at what is asked before the answer.</source>
        <translation>هكذا يكون الأمر مع أنصاف أقطار أو كثافات من قبل ⁦`on_load`⁩: الكتلة التي تُحسب قبل ضبطها تحتفظ بالقيمة القديمة. انظر إلى الترتيب هناك، وما الذي يُسأل قبل الاستجابة.</translation>
    </message>
    <message>
        <source>Look at what the answer takes for the masses there, and at what is asked before it.</source>
        <translation>انظر ما الذي تأخذه الاستجابة هناك كتلتين، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>In your own scene the hit does not use the e that it has</source>
        <translation>في مشهدك لا يستعمل التصادم e الذي له</translation>
    </message>
    <message>
        <source>With e = %1 a hit does not come out right</source>
        <translation>مع ⁦e = %1⁩ لا تصح نتيجة التصادم</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4, e = %5: </source>
        <translation>مع ⁦r₁ = %1⁩ و⁦r₂ = %2 m⁩، و⁦ρ₁ = %3⁩ و⁦ρ₂ = %4⁩، و⁦e = %5⁩: </translation>
    </message>
    <message>
        <source>e = %1 is not the value that is asked for</source>
        <translation>القيمة ⁦e = %1⁩ ليست المطلوبة</translation>
    </message>
    <message>
        <source>Circle %5 came to the %1 with %2 m/s and left it with %3 m/s; %4 m/s is right.</source>
        <translation>جاءت الدائرة ⁨%5⁩ إلى ⁨%1⁩ بسرعة ⁦%2 m/s⁩ وغادرته بسرعة ⁦%3 m/s⁩؛ الصواب ⁦%4 m/s⁩.</translation>
    </message>
    <message>
        <source>The normal of the side walls points along x, that of floor and ceiling along y.</source>
        <translation>ناظم الجدارين الجانبيين على امتداد x، وناظم الأرضية والسقف على امتداد y.</translation>
    </message>
    <message>
        <source>Its velocity still points into the wall: look at the sign.</source>
        <translation>لا تزال السرعة تشير إلى داخل الجدار: انظر إلى الإشارة.</translation>
    </message>
    <message>
        <source>Heights go with e², speeds with e.</source>
        <translation>الارتفاعات تتبع e²، ومقادير السرعات تتبع e.</translation>
    </message>
    <message>
        <source>1 − e is what is lost; e is what is left.</source>
        <translation>⁦1 − e⁩ هو ما يُفقد؛ وe هو ما يبقى.</translation>
    </message>
    <message>
        <source>1 + e is the whole change of the velocity, e what comes back.</source>
        <translation>⁦1 + e⁩ هو تغير السرعة كله، وe ما يعود منها.</translation>
    </message>
    <message>
        <source>In a corner only one part of the velocity of %who turns round</source>
        <translation>في الركن لا تنعكس إلا مركّبة واحدة من سرعة %who</translation>
    </message>
    <message>
        <source>A hit soon after another is not answered</source>
        <translation>تصادم بُعيد آخر لا يلقى استجابة</translation>
    </message>
    <message>
        <source>A later hit is not answered</source>
        <translation>تصادم لاحق لا يلقى استجابة</translation>
    </message>
    <message>
        <source>Look for a factor ½, or for a second half that is missing.</source>
        <translation>ابحث عن عامل ⁦½⁩، أو عن نصف ثانٍ ناقص.</translation>
    </message>
    <message>
        <source>In your own scene gravity is %1 m/s²; the velocity changes by %2 m/s in the first step and by %3 m/s in the second. Look at what else changes the velocity, away from any hit.</source>
        <translation>في مشهدك الجاذبية ⁦%1 m/s²⁩؛ وتتغير السرعة بمقدار ⁦%2 m/s⁩ في الخطوة الأولى وبمقدار ⁦%3 m/s⁩ في الثانية. انظر ما الذي يغيّر السرعة غير ذلك، بعيدًا عن أي تصادم.</translation>
    </message>
    <message>
        <source>After a hit the circles still run into each other</source>
        <translation>بعد التصادم تستمر الدائرتان في التقارب</translation>
    </message>
    <message>
        <source>After a hit the circles part faster than they met</source>
        <translation>بعد التصادم تفترق الدائرتان أسرع مما التقتا</translation>
    </message>
    <message>
        <source>Something away from every wall changes the velocity of %who</source>
        <translation>شيء ما بعيدًا عن كل جدار يغيّر سرعة %who</translation>
    </message>
    <message>
        <source>The velocity of %who is taken from circle %1</source>
        <translation>تؤخذ سرعة %who من الدائرة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Away from every wall a low speed of %who is taken away</source>
        <translation>بعيدًا عن كل جدار تُمحى سرعة %who إن كانت صغيرة</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, far from every wall and every other circle; a faster one goes on. Look at the conditions in front of the lines that change the velocity.</source>
        <translation>من ⁦%1 m/s⁩ في البداية تصير السرعة ⁦%2 m/s⁩ بعد خطوة، بعيدًا عن كل جدار وكل دائرة أخرى؛ أما الأسرع فيمضي. انظر إلى الشروط التي قبل الأسطر التي تغيّر السرعة.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: half of that. From the centre to the rim it is the whole radius.</source>
        <translation>نصف قطر الدائرة ⁨%3⁩ هو ⁦%1 m⁩، ويأتي الارتداد حين يكون المركز على بعد ⁦%2 m⁩ من الجدار: نصف ذلك. من المركز إلى الحافة نصف القطر كله.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: twice the radius. From the centre to the rim it is one.</source>
        <translation>نصف قطر الدائرة ⁨%3⁩ هو ⁦%1 m⁩، ويأتي الارتداد حين يكون المركز على بعد ⁦%2 m⁩ من الجدار: ضعف نصف القطر. من المركز إلى الحافة نصف قطر واحد.</translation>
    </message>
    <message>
        <source>Circle %3 turns when its centre is one radius, %1 m, past the wall. Of its two ends the near one touches first: look at the sign in front of the radius.</source>
        <translation>ترتد الدائرة ⁨%3⁩ حين يتجاوز مركزها الجدار بنصف قطر، ⁦%1 m⁩. من طرفي الدائرة يلامس القريبُ أولًا: انظر إلى الإشارة أمام نصف القطر.</translation>
    </message>
    <message>
        <source>Thrown towards the %1, circle %6 changed its velocity from %2 to %3 m/s in the first step, with its centre still %4 m from that wall; its radius is %5 m. Look at the conditions: which of them is true away from every wall?</source>
        <translation>عند رمي الدائرة ⁨%6⁩ نحو ⁨%1⁩ تغيرت سرعتها من ⁨%2⁩ إلى ⁦%3 m/s⁩ في الخطوة الأولى، والمركز لا يزال على بعد ⁦%4 m⁩ من ذلك الجدار؛ ونصف القطر ⁦%5 m⁩. انظر إلى الشروط: أيّها صادق بعيدًا عن كل جدار؟</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the second step of a run and %3 m where it starts alike %4 s later, with the same Δt.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ قطعت ⁦%2 m⁩ في الخطوة الثانية من التشغيل، و⁦%3 m⁩ إذا انطلقت مثلها بعد ⁦%4 s⁩، مع Δt نفسها.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s after the first step of a run and %3 m/s where it starts alike %4 s later.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ كانت سرعتها ⁦%2 m/s⁩ بعد الخطوة الأولى من التشغيل، و⁦%3 m/s⁩ إذا انطلقت مثلها بعد ⁦%4 s⁩.</translation>
    </message>
    <message>
        <source>The step of %who depends on how long the run has lasted</source>
        <translation>خطوة %who تتوقف على ما مضى من زمن التشغيل</translation>
    </message>
    <message>
        <source>How long a step lasts is the parameter of `on_update`; `time` is the time since the start, and `step` counts.</source>
        <translation>مدة الخطوة هي معامل ⁦`on_update`⁩؛ أما ⁦`time`⁩ فالزمن منذ البداية، و⁦`step`⁩ يعدّ الخطوات.</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with r₁ = %2 and r₂ = %3 m as if it were %4 times. Compare the lines for the two masses.</source>
        <translation>دائرتان متساويتان في نصف القطر والكثافة تستجيبان كأن كتلة الدائرة 2 تساوي كتلة الدائرة 1 مضروبةً في ⁨%1⁩، ومع ⁦r₁ = %2⁩ و⁦r₂ = %3 m⁩ مضروبةً في ⁨%4⁩. قارن بين سطري الكتلتين.</translation>
    </message>
    <message>
        <source>The hits hardly depend on the radii</source>
        <translation>التصادمات لا تكاد تتوقف على نصفي القطرين</translation>
    </message>
    <message>
        <source>e acts on more than the rebound</source>
        <translation>المعامل e يؤثر في أكثر من الارتداد</translation>
    </message>
    <message>
        <source>The circles part e times as fast as they met, as they should; but what both have together, their momentum, changes, too.</source>
        <translation>تفترق الدائرتان بسرعة التقائهما مضروبةً في e كما ينبغي؛ لكن ما لهما معًا، أي كمية حركتهما، يتغير أيضًا.</translation>
    </message>
    <message>
        <source>A hit changes the places of the circles, not their velocities</source>
        <translation>التصادم يغيّر مكاني الدائرتين، لا سرعتيهما</translation>
    </message>
    <message>
        <source>When they touched, circle %1 was put to %2 m, far from where it came from, and both kept their velocities. A hit changes velocities; each circle stays near its own way.</source>
        <translation>عندما تلامستا وُضعت الدائرة ⁨%1⁩ عند ⁦%2 m⁩، بعيدًا عن المكان الذي جاءت منه، وأبقت كلتاهما سرعتها. التصادم يغيّر السرعات؛ وكل دائرة تبقى قرب مسارها.</translation>
    </message>
    <message>
        <source>Circles that come nearer slowly are not answered</source>
        <translation>الدائرتان اللتان تقتربان ببطء لا تلقيان استجابة</translation>
    </message>
    <message>
        <source>With ρ₁ = %1 and ρ₂ = %2, e = %3: </source>
        <translation>مع ⁦ρ₁ = %1⁩ و⁦ρ₂ = %2⁩، و⁦e = %3⁩: </translation>
    </message>
    <message>
        <source>What both have in common comes out right. Of the rebound, the part with e, circle 1 gets the share m₁/(m₁ + m₂) and circle 2 the share m₂/(m₁ + m₂): the lighter one should get more.</source>
        <translation>ما تشتركان فيه يخرج صحيحًا. ومن الارتداد، أي الجزء الذي فيه e، تنال الدائرة 1 الحصة ⁦m₁/(m₁ + m₂)⁩ والدائرة 2 الحصة ⁦m₂/(m₁ + m₂)⁩: ينبغي أن تنال الأخف أكثر.</translation>
    </message>
    <message>
        <source>The other one leaves as it should. Look at what is worked out for this one.</source>
        <translation>الأخرى تغادر كما ينبغي. انظر إلى ما يُحسب لهذه.</translation>
    </message>
    <message>
        <source>Of two equal circles circle 2 leaves a hit as it came</source>
        <translation>من دائرتين متساويتين تغادر الدائرة 2 التصادم كما جاءت</translation>
    </message>
    <message>
        <source>Of two equal circles circle 1 leaves a hit as it came</source>
        <translation>من دائرتين متساويتين تغادر الدائرة 1 التصادم كما جاءت</translation>
    </message>
    <message>
        <source>There circle 2 answers as if it were %1 times as heavy as circle 1; as your program does in other scenes, it would be %2 times.</source>
        <translation>هناك تستجيب الدائرة 2 كأن كتلتها تساوي كتلة الدائرة 1 مضروبةً في ⁨%1⁩؛ وبحسب ما يفعله برنامجك في المشاهد الأخرى يكون العامل ⁨%2⁩.</translation>
    </message>
    <message>
        <source>They met with %1 m/s and parted with %2 m/s, which is e = %3, and `restitution` is %4. In %5 hits tried in other scenes they part with e times the speed.</source>
        <translation>التقتا بسرعة ⁦%1 m/s⁩ وافترقتا بسرعة ⁦%2 m/s⁩، أي ⁦e = %3⁩، و⁦`restitution`⁩ هو ⁨%4⁩. في ⁨%5⁩ من التصادمات التي جُرّبت في مشاهد أخرى تفترقان بالسرعة مضروبةً في e.</translation>
    </message>
    <message>
        <source>A copy of e that is made before e is set keeps the old value.</source>
        <translation>نسخةٌ من e صُنعت قبل ضبط e تحتفظ بالقيمة القديمة.</translation>
    </message>
    <message>
        <source>A later hit is answered along the line of an earlier one</source>
        <translation>تصادم لاحق يُستجاب له على خط تصادم سابق</translation>
    </message>
    <message>
        <source>Two circles met with their line of centres at %1°, and again, back from a wall, with it at %2°. Both times they were pushed along %3°. Every hit has a normal of its own: work it out anew.</source>
        <translation>التقت دائرتان وخط مركزيهما عند ⁦%1°⁩، ثم مرة أخرى بعد العودة من جدار وهو عند ⁦%2°⁩. وفي المرتين دُفعتا على ⁦%3°⁩. لكل تصادم ناظم خاص به: احسبه من جديد.</translation>
    </message>
    <message>
        <source>A later hit is answered with another e</source>
        <translation>تصادم لاحق يُستجاب له بقيمة e أخرى</translation>
    </message>
    <message>
        <source>With e = %1 two circles parted with %2 times the speed that they met with; in their second hit, back from a wall, it was %3 times. Look at what your program keeps from one hit to the next.</source>
        <translation>مع ⁦e = %1⁩ افترقت دائرتان بسرعة لقائهما مضروبةً في ⁨%2⁩؛ وفي تصادمهما الثاني، بعد العودة من جدار، مضروبةً في ⁨%3⁩. انظر إلى ما يحتفظ به برنامجك من تصادم إلى الذي يليه.</translation>
    </message>
    <message>
        <source>Circles that meet slowly are answered in another way</source>
        <translation>الدائرتان اللتان تلتقيان ببطء يُستجاب لهما بطريقة أخرى</translation>
    </message>
    <message>
        <source>Where they meet with %1 m/s, it comes out right. The law is the same for every speed.</source>
        <translation>حين تلتقيان بسرعة ⁦%1 m/s⁩ تخرج النتيجة صحيحة. القانون واحد لكل سرعة.</translation>
    </message>
    <message>
        <source>twice the smaller radius</source>
        <translation>ضعف نصف القطر الأصغر</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and went on past it; with %4 m/s it is turned round. How fast it comes does not matter: what counts is whether its rim is past the wall, and which way it moves.</source>
        <translation>جاءت الدائرة ⁨%1⁩ إلى ⁨%2⁩ بسرعة ⁦%3 m/s⁩ ومضت إلى الخارج؛ وبسرعة ⁦%4 m/s⁩ تُردّ. لا تهمّ سرعة مجيئها: المهم هل تجاوزت حافتها الجدار، وإلى أين تتحرك.</translation>
    </message>
    <message>
        <source>Here the line of centres was at %1°; with %2° the hits come out right.</source>
        <translation>كان خط المركزين هنا عند ⁦%1°⁩؛ وعند ⁦%2°⁩ تصحّ التصادمات.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, one step later it is %2 m from where it was at the start of a run, and %3 m where it starts alike %4 s later. A step *adds* a way to the old position.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ كانت بعد خطوة واحدة على بُعد ⁦%2 m⁩ من مكانها في بداية التشغيل، وعلى بُعد ⁦%3 m⁩ إذا انطلقت مثلها بعد ⁦%4 s⁩. الخطوة *تضيف* مسافة إلى الموضع القديم.</translation>
    </message>
    <message>
        <source> (only in y)</source>
        <translation> (في y فقط)</translation>
    </message>
    <message>
        <source> (only in x)</source>
        <translation> (في x فقط)</translation>
    </message>
    <message>
        <source>Where the masses differ, the total momentum is not kept</source>
        <translation>عندما تختلف الكتلتان لا تُحفَظ كمية الحركة الكلية</translation>
    </message>
    <message>
        <source>With ρ₁ = %1 and ρ₂ = %2 the change of v₁ was %3 times that of v₂ where e is %4, and %5 times where it is %6; m₂/m₁ = %7 is right, whatever e is. One push changes both: look at what the two formulas have in common.</source>
        <translation>مع ⁦ρ₁ = %1⁩ و⁦ρ₂ = %2⁩ كان تغير v₁ يساوي تغير v₂ مضروبًا في ⁨%3⁩ عندما ⁦e = %4⁩، ومضروبًا في ⁨%5⁩ عندما ⁦e = %6⁩؛ الصواب ⁦m₂/m₁ = %7⁩ مهما كان e. دفع واحد يغيّر السرعتين: انظر إلى ما تشترك فيه الصيغتان.</translation>
    </message>
    <message>
        <source>e acts only after the first hit</source>
        <translation>لا يؤثر e إلا بعد التصادم الأول</translation>
    </message>
    <message>
        <source>With e = %1 two circles parted with %2 times the speed that they met with; in their second hit, back from a wall, it was %3 times. Look at when your answer learns what e is: that comes too late.</source>
        <translation>مع ⁦e = %1⁩ افترقت دائرتان بسرعة لقائهما مضروبةً في ⁨%2⁩؛ وفي تصادمهما الثاني، بعد العودة من جدار، مضروبةً في ⁨%3⁩. انظر متى تعرف استجابتك قيمة e: ذلك يأتي متأخرًا.</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and turned when its rim was between %4 and %5 m from it; with %6 m/s between %7 and %8 m. That is the way of a second: a step takes it v Δt further, not v.</source>
        <translation>جاءت الدائرة ⁨%1⁩ إلى ⁨%2⁩ بسرعة ⁦%3 m/s⁩ وارتدت حين كانت حافتها على بعد بين ⁨%4⁩ و⁦%5 m⁩ منه؛ وبسرعة ⁦%6 m/s⁩ بين ⁨%7⁩ و⁦%8 m⁩. هذه مسافة ثانية كاملة: الخطوة تنقلها ⁦v&#xa0;Δt⁩ لا v.</translation>
    </message>
    <message>
        <source>Beside a wall the velocity of both circles changes at once</source>
        <translation>بجانب جدار تتغير سرعتا الدائرتين معًا</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s, and ran into each other.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلهما التقتا عند ⁦%2 m⁩ بسرعة ⁦%3 m/s⁩ وتداخلتا.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s and e = %4.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلهما التقتا عند ⁦%2 m⁩ بسرعة ⁦%3 m/s⁩ ومع ⁦e = %4⁩.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلهما التقتا عند ⁦%2 m⁩ بسرعة ⁦%3 m/s⁩.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s, and were answered before they touched.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلهما التقتا عند ⁦%2 m⁩ بسرعة ⁦%3 m/s⁩ واستجابتا قبل أن تتلامسا.</translation>
    </message>
    <message>
        <source>It was meeting number %1 of that run, %2 s after the one before.</source>
        <translation>كان اللقاء رقم ⁨%1⁩ في ذلك التشغيل، بعد سابقه بمدة ⁦%2 s⁩.</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and left it with %6 m/s; %7 m/s is right.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلها جاءت الدائرة ⁨%2⁩ إلى ⁨%3⁩ عند ⁦%4 m⁩ بسرعة ⁦%5 m/s⁩ وغادرته بسرعة ⁦%6 m/s⁩؛ الصواب ⁦%7 m/s⁩.</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and went on past it.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلها جاءت الدائرة ⁨%2⁩ إلى ⁨%3⁩ عند ⁦%4 m⁩ بسرعة ⁦%5 m/s⁩ ومضت إلى ما بعده.</translation>
    </message>
    <message>
        <source>In a scene in which circle %1 alone has a velocity, %who goes on by that times Δt. Each circle moves with its own velocity: look at the names in the line that moves it.</source>
        <translation>في مشهد لا سرعة فيه إلا للدائرة ⁨%1⁩ تتقدم %who بمقدار تلك السرعة مضروبة في ⁦Δt⁩. كل دائرة تتحرك بسرعتها هي: انظر إلى الأسماء في السطر الذي يحرّكها.</translation>
    </message>
    <message>
        <source>Its velocity still points into the wall: look at what it is worked out from.</source>
        <translation>لا تزال السرعة تشير إلى داخل الجدار: انظر ممّ تُحسب.</translation>
    </message>
    <message>
        <source>The flight of %who depends on another circle</source>
        <translation>طيران %who يتوقف على دائرة أخرى</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the second step of %3 s; with every other circle at rest and elsewhere %4 m.</source>
        <translation>إذا بدأت بسرعة ⁦%1 m/s⁩ تقدمت ⁦%2 m⁩ في الخطوة الثانية ومدتها ⁦%3 s⁩؛ وإذا كانت كل دائرة أخرى ساكنة في مكان آخر تقدمت ⁦%4 m⁩.</translation>
    </message>
    <message>
        <source>They are far from each other. Look at what the lines that move one circle take from another, and at what is asked before them.</source>
        <translation>وهي بعيدة بعضها عن بعض. انظر ماذا تأخذ الأسطر التي تحرّك دائرة من دائرة أخرى، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>What gravity adds to the way of %who goes with Δt, not with Δt²</source>
        <translation>ما تضيفه الجاذبية إلى مسافة %who يتناسب مع ⁦Δt⁩ لا مع ⁦Δt²⁩</translation>
    </message>
    <message>
        <source>A way is a length, as g Δt² is; g Δt is a velocity and g an acceleration.</source>
        <translation>المسافة طول، ومثلها ⁦g Δt²⁩؛ أما ⁦g Δt⁩ فسرعة و⁦g⁩ تسارع.</translation>
    </message>
    <message>
        <source>Every step moves %who by a fixed way besides v Δt</source>
        <translation>كل خطوة تحرّك %who مسافة ثابتة زيادة على ⁦v Δt⁩</translation>
    </message>
    <message>
        <source>Something besides its own velocity moves %who</source>
        <translation>شيء غير السرعة الذاتية يحرّك %who</translation>
    </message>
    <message>
        <source>What a step adds to the way of %who besides v Δt is no method&apos;s</source>
        <translation>ما تضيفه الخطوة إلى مسافة %who زيادة على ⁦v Δt⁩ ليس من أي طريقة</translation>
    </message>
    <message>
        <source>Besides v Δt it goes %1 m in a step of %2 s under gravity %3 m/s², and %4 m in one of %5 s. Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods ½ g Δt².</source>
        <translation>زيادة على ⁦v Δt⁩ تتقدم ⁦%1 m⁩ في خطوة مدتها ⁦%2 s⁩ تحت الجاذبية ⁦%3 m/s²⁩، و⁦%4 m⁩ في خطوة مدتها ⁦%5 s⁩. أويلر لا تضيف شيئًا إلى ⁦v Δt⁩، وأويلر التماثلية تضيف ⁦g Δt²⁩، والطرائق الدقيقة ⁦½ g Δt²⁩.</translation>
    </message>
    <message>
        <source>The name `gravity` holds the value of the scene; look where your program has one of its own.</source>
        <translation>الاسم ⁦`gravity`⁩ يحمل قيمة المشهد؛ انظر أين يستعمل برنامجك قيمة من عنده.</translation>
    </message>
    <message>
        <source>Something besides gravity accelerates %who</source>
        <translation>شيء غير الجاذبية يسرّع %who</translation>
    </message>
    <message>
        <source>Each time that is %1 m/s² more than gravity gives.</source>
        <translation>وهذا في كل مرة أكثر مما تعطيه الجاذبية بمقدار ⁦%1 m/s²⁩.</translation>
    </message>
    <message>
        <source>The acceleration of %who is not that of gravity</source>
        <translation>تسارع %who ليس تسارع الجاذبية</translation>
    </message>
    <message>
        <source>In one of %1 s it changes by %2 m/s, and should by %3 m/s.</source>
        <translation>وفي خطوة مدتها ⁦%1 s⁩ تتغير بمقدار ⁦%2 m/s⁩، والصواب ⁦%3 m/s⁩.</translation>
    </message>
    <message>
        <source>How gravity acts on %who depends on the timestep</source>
        <translation>تأثير الجاذبية في %who يتوقف على طول الخطوة</translation>
    </message>
    <message>
        <source>In every step gravity must change its velocity: look for the line that does it, and at what is asked before it.</source>
        <translation>يجب أن تغيّر الجاذبية السرعة في كل خطوة: ابحث عن السطر الذي يفعل ذلك، وعمّا يُسأل قبله.</translation>
    </message>
    <message>
        <source>The velocity of %who changes far from everything</source>
        <translation>تتغير سرعة %who بعيدًا عن كل شيء</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, it has %2 m/s one step of %3 s later, far from every wall and every other circle; gravity gives it %4 m/s in a step. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>إذا رُميت بسرعة ⁦%1 m/s⁩ كانت سرعتها ⁦%2 m/s⁩ بعد خطوة مدتها ⁦%3 s⁩، بعيدةً عن كل جدار وكل دائرة أخرى؛ والجاذبية تعطيها ⁦%4 m/s⁩ في الخطوة. انظر أي الأسطر تغيّر سرعتها هناك، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>A slower one goes on as it should.</source>
        <translation>والأبطأ تمضي كما يجب.</translation>
    </message>
    <message>
        <source>A faster one goes on as it should.</source>
        <translation>والأسرع تمضي كما يجب.</translation>
    </message>
    <message>
        <source>Look at what the lines that change the velocity take, and at what is asked before them.</source>
        <translation>انظر ماذا تأخذ الأسطر التي تغيّر السرعة، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² and with the velocity %2 m/s it changes by %3 m/s in a step of %4 s, with %5 m/s by %6 m/s; %7 and %8 m/s are right. Look at what the lines that change the velocity take, and at what is asked before them.</source>
        <translation>تحت الجاذبية ⁦%1 m/s²⁩ وبسرعة ⁦%2 m/s⁩ يكون التغير ⁦%3 m/s⁩ في خطوة مدتها ⁦%4 s⁩، وبسرعة ⁦%5 m/s⁩ يكون ⁦%6 m/s⁩؛ الصواب ⁨%7⁩ و⁦%8 m/s⁩. انظر ماذا تأخذ الأسطر التي تغيّر السرعة، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>The acceleration of %who depends on the place</source>
        <translation>تسارع %who يتوقف على الموضع</translation>
    </message>
    <message>
        <source>At rest under gravity %1 m/s² it is accelerated by %2 m/s² at %3 m and by %4 m/s² at %5 m; %6 and %7 m/s² are right.</source>
        <translation>في السكون تحت الجاذبية ⁦%1 m/s²⁩ يكون التسارع ⁦%2 m/s²⁩ عند ⁦%3 m⁩ و⁦%4 m/s²⁩ عند ⁦%5 m⁩؛ الصواب ⁨%6⁩ و⁦%7 m/s²⁩.</translation>
    </message>
    <message>
        <source>The velocity of %who changes by itself otherwise than asked</source>
        <translation>سرعة %who تؤثر في نفسها على غير المطلوب</translation>
    </message>
    <message>
        <source>It had %1 m/s, and %2 m/s one step of %3 s later, with nothing near that it could hit. Look at the lines that turn it, and at what is asked before them: is it true although nothing touches?</source>
        <translation>كانت سرعتها ⁦%1 m/s⁩، وصارت ⁦%2 m/s⁩ بعد خطوة مدتها ⁦%3 s⁩، ولا شيء قريب يمكن أن تصدمه. انظر إلى الأسطر التي تعكسها، وما الذي يُسأل قبلها: أهو صحيح مع أن شيئًا لا يلمس شيئًا؟</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated by %2 m/s² for every m/s of its velocity; %3 is right.</source>
        <translation>مع ⁦Δt = %1 s⁩ يكون التسارع ⁦%2 m/s²⁩ لكل ⁦m/s⁩ من السرعة؛ الصواب ⁨%3⁩.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated in x by %2 m/s² for every m/s of its velocity in x; %3 is right.</source>
        <translation>مع ⁦Δt = %1 s⁩ يكون التسارع في ⁦x⁩ بمقدار ⁦%2 m/s²⁩ لكل ⁦m/s⁩ من السرعة في ⁦x⁩؛ الصواب ⁨%3⁩.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated in y by %2 m/s² for every m/s of its velocity in y; %3 is right.</source>
        <translation>مع ⁦Δt = %1 s⁩ يكون التسارع في ⁦y⁩ بمقدار ⁦%2 m/s²⁩ لكل ⁦m/s⁩ من السرعة في ⁦y⁩؛ الصواب ⁨%3⁩.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated by %2 m/s² for every m/s of its velocity in x, and by %3 m/s² for every m/s in y; %4 and %5 are right.</source>
        <translation>مع ⁦Δt = %1 s⁩ يكون التسارع ⁦%2 m/s²⁩ لكل ⁦m/s⁩ من السرعة في ⁦x⁩، و⁦%3 m/s²⁩ لكل ⁦m/s⁩ في ⁦y⁩؛ الصواب ⁨%4⁩ و⁨%5⁩.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is %2 m/s².</source>
        <translation>ومع ⁦Δt = %1 s⁩ يكون ⁦%2 m/s²⁩.</translation>
    </message>
    <message>
        <source>It starts with %1 m/s, and has %2 m/s one step later; nothing that it could hit is near. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>تبدأ بسرعة ⁦%1 m/s⁩، وسرعتها بعد خطوة واحدة ⁦%2 m/s⁩؛ ولا شيء قريب يمكن أن تصدمه. انظر أي الأسطر تغيّر سرعتها هناك، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>It is the value that the scene has.</source>
        <translation>هذه هي القيمة التي للمشهد.</translation>
    </message>
    <message>
        <source>Look at what your program assigns to %1 before the first step.</source>
        <translation>انظر ماذا يُسند برنامجك إلى ⁦%1⁩ قبل الخطوة الأولى.</translation>
    </message>
    <message>
        <source>Behind `local`, %1 is the name of another variable: the scene keeps its own value.</source>
        <translation>بعد ⁦`local`⁩ يكون ⁦%1⁩ اسمًا لمتغير آخر: ويبقى للمشهد قيمته.</translation>
    </message>
    <message>
        <source>Nothing in your program assigns to %1 before the first step: it is the value that the scene has.</source>
        <translation>لا شيء في برنامجك يُسند إلى ⁦%1⁩ قبل الخطوة الأولى: فهي القيمة التي للمشهد.</translation>
    </message>
    <message>
        <source>Gravity is %1 m/s², not %2

So it is when the run begins.</source>
        <translation>الجاذبية ⁦%1 m/s²⁩، لا ⁨%2⁩

هكذا هي حين يبدأ التشغيل.</translation>
    </message>
    <message>
        <source>So it is when the run begins; in this step your own scene should have e = %1.</source>
        <translation>هكذا هو عند بدء التشغيل؛ وفي هذه المرحلة يجب أن يكون لمشهدك ⁦e = %1⁩.</translation>
    </message>
    <message>
        <source>What gravity adds to the way of %who does not depend on Δt</source>
        <translation>ما تضيفه الجاذبية إلى مسافة %who لا يتوقف على ⁦Δt⁩</translation>
    </message>
    <message>
        <source>In a step of %1 s it keeps as much of it, %2 times: so what happens in a second depends on Δt.</source>
        <translation>وفي خطوة مدتها ⁦%1 s⁩ تحتفظ منها بالقدر نفسه، ⁨%2⁩ منها: فما يحدث في ثانية يتوقف على ⁦Δt⁩.</translation>
    </message>
    <message>
        <source>Every step moves %who on from where circle %1 is</source>
        <translation>كل خطوة تحرّك %who من حيث توجد الدائرة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Started with %1 m/s, its velocity changes by %2 m/s in the second step of %3 s; with every other circle at rest and elsewhere by %4 m/s.</source>
        <translation>إذا بدأت بسرعة ⁦%1 m/s⁩ تغيّرت سرعتها ⁦%2 m/s⁩ في الخطوة الثانية ومدتها ⁦%3 s⁩؛ وإذا كانت كل دائرة أخرى ساكنة في مكان آخر تغيّرت ⁦%4 m/s⁩.</translation>
    </message>
    <message>
        <source>The acceleration of %who is opposite to gravity</source>
        <translation>تسارع %who معاكس للجاذبية</translation>
    </message>
    <message>
        <source>Nothing changes the velocity of circle %1

In your own scene it has %2 m/s from the start to the end of %3 s, though it comes to a wall and to another circle. Both must give it a new velocity: look for where that is assigned.</source>
        <translation>لا شيء يغيّر سرعة الدائرة ⁨%1⁩

في مشهدك سرعتها ⁦%2 m/s⁩ من البداية إلى نهاية ⁦%3 s⁩، مع أنها تصل إلى جدار وإلى دائرة أخرى. وكلاهما يجب أن يعطيها سرعة جديدة: ابحث أين تُسند.</translation>
    </message>
    <message>
        <source>Circle %1 does not move as its velocity says

At %2 s of your own scene it moves by %3 m in a step of %4 s; its velocity is still the %5 m/s of the start. A program that keeps velocities in variables of its own must also assign them to the circles, as to `circle%1.velocity`.

Until this is right, no more can be said of walls and hits.</source>
        <translation>لا تتحرك الدائرة ⁨%1⁩ كما تقول سرعتها

عند ⁦%2 s⁩ من مشهدك تتحرك بمقدار ⁦%3 m⁩ في خطوة مدتها ⁦%4 s⁩، وما زالت سرعتها سرعة البداية ⁦%5 m/s⁩. والبرنامج الذي يحفظ السرعات في متغيرات خاصة به يجب أن يسندها إلى الدائرتين أيضًا، مثل ⁦`circle%1.velocity`⁩.

وبسبب هذا لا يمكن الحكم على الجدران والتصادمات بعد.</translation>
    </message>
    <message>
        <source>Circle %1 does not move as its velocity says

At %2 s of your own scene it moves by %3 m in a step of %4 s; its velocity is %5 m/s, of which the %6 is still that of the start. A program that keeps velocities in variables of its own must assign both parts of them to the circles, as to `circle%1.velocity`.

Until this is right, no more can be said of walls and hits.</source>
        <translation>لا تتحرك الدائرة ⁨%1⁩ كما تقول سرعتها

عند ⁦%2 s⁩ من مشهدك تتحرك بمقدار ⁦%3 m⁩ في خطوة مدتها ⁦%4 s⁩، وسرعتها ⁦%5 m/s⁩، وما زالت المركّبة ⁦%6⁩ منها كما كانت في البداية. والبرنامج الذي يحفظ السرعات في متغيرات خاصة به يجب أن يسند مركّبتيها معًا إلى الدائرتين، مثل ⁦`circle%1.velocity`⁩.

وبسبب هذا لا يمكن الحكم على الجدران والتصادمات بعد.</translation>
    </message>
    <message>
        <source>Look at what the line that changes the position takes, and at what is asked before it.</source>
        <translation>انظر ماذا يأخذ السطر الذي يغيّر الموضع، وما الذي يُسأل قبله.</translation>
    </message>
    <message>
        <source>The method that moves %who depends on the velocity</source>
        <translation>الطريقة التي تحرّك %who تتوقف على السرعة</translation>
    </message>
    <message>
        <source>Where nothing rubs, a push points along the normal only.</source>
        <translation>حيث لا احتكاك لا تؤثر الدفعة إلا على امتداد الناظم.</translation>
    </message>
    <message>
        <source>Hits at the %walls hold %who and turn no velocity round</source>
        <translation>التصادمات عند %walls تمسك %who ولا تعكس أي سرعة</translation>
    </message>
    <message>
        <source>At the %walls the way of %who turns round, not its velocity</source>
        <translation>عند %walls ينعكس مسار %who لا سرعتها</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the velocity of %who round too late</source>
        <translation>التصادمات عند %walls تعكس متأخرةً السرعة لـ %who</translation>
    </message>
    <message>
        <source>It is put back at once, and its velocity points away from the wall only %1 s later.</source>
        <translation>تُعاد الدائرة في الحال، ولا تشير سرعتها بعيدًا عن الجدار إلا بعد ⁦%1 s⁩.</translation>
    </message>
    <message>
        <source>In every step it is kept from going on, and its velocity still points into it.</source>
        <translation>في كل خطوة تُمنع الدائرة من المضيّ، ولا تزال سرعتها تشير إلى داخل الجدار.</translation>
    </message>
    <message>
        <source>It is kept from going on, and its velocity stays as it was.</source>
        <translation>تُمنع الدائرة من المضيّ وتبقى سرعتها كما كانت.</translation>
    </message>
    <message>
        <source>It goes back from the wall while its velocity still points into it: look at what is assigned to that.</source>
        <translation>تعود من الجدار وسرعتها ما زالت تتجه إليه: انظر إلى ما يُسند إليها.</translation>
    </message>
    <message>
        <source>At the %walls %who gets the velocity of the other circle</source>
        <translation>عند %walls تأخذ %who سرعة الدائرة الأخرى</translation>
    </message>
    <message>
        <source>The other circle had %1 m/s. Look at whose velocity the line takes.</source>
        <translation>كانت سرعة الدائرة الأخرى ⁦%1 m/s⁩. انظر سرعة أيّ دائرة يأخذها السطر.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the wrong part of the velocity of %who</source>
        <translation>التصادمات عند %walls تعكس المركّبة الخاطئة من سرعة %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the whole velocity of %who round</source>
        <translation>التصادمات عند %walls تعكس سرعة %who كاملة</translation>
    </message>
    <message>
        <source>At the %walls e also shortens the part of %who along the wall</source>
        <translation>عند %walls يقصّر e أيضًا مركّبة %who الموازية للجدار</translation>
    </message>
    <message>
        <source>At the %walls e acts on the wrong part of the velocity of %who</source>
        <translation>عند %walls يؤثر e في المركّبة الخاطئة من سرعة %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the part of %who along the wall round, too</source>
        <translation>التصادمات عند %walls تعكس مركّبة %who الموازية للجدار أيضًا</translation>
    </message>
    <message>
        <source>Hits at the %walls take the part of %who along the wall away</source>
        <translation>التصادمات عند %walls تأخذ مركّبة %who الموازية للجدار</translation>
    </message>
    <message>
        <source>Hits at the %walls change the part of %who along the wall</source>
        <translation>التصادمات عند %walls تغيّر مركّبة %who الموازية للجدار</translation>
    </message>
    <message>
        <source>At the %walls a number stands for e, for %who</source>
        <translation>عند %walls يقوم عدد مقام e، بالنسبة إلى %who</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 e of the speed back, not e</source>
        <translation>التصادمات عند %walls تعيد إلى %who السرعة مضروبةً في ⁦%1 e⁩، لا في e</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who a speed of their own</source>
        <translation>التصادمات عند %walls تعطي %who سرعة من عندها</translation>
    </message>
    <message>
        <source>With e = %1 a hit with %2 m/s into the wall gives %3 times the speed back, one with %4 m/s %5 times: the share should be the same for every speed.</source>
        <translation>مع ⁦e = %1⁩ يعيد اصطدام بسرعة ⁦%2 m/s⁩ نحو الجدار السرعة مضروبةً في ⁨%3⁩، وآخر بسرعة ⁦%4 m/s⁩ مضروبةً في ⁨%5⁩: يجب أن تكون النسبة نفسها لكل سرعة.</translation>
    </message>
    <message>
        <source>With e = %1 it is %2 times the speed, with e = %3 %4 times.</source>
        <translation>مع ⁦e = %1⁩ تعود السرعة مضروبةً في ⁨%2⁩، ومع ⁦e = %3⁩ مضروبةً في ⁨%4⁩.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who between %1 and %2 times the speed back</source>
        <translation>التصادمات عند %walls تعيد إلى %who السرعة مضروبةً في ما بين ⁨%1⁩ و⁨%2⁩</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 times the speed back</source>
        <translation>التصادمات عند %walls تعيد إلى %who السرعة مضروبةً في ⁨%1⁩</translation>
    </message>
    <message>
        <source>Look at what the new velocity is worked out from.</source>
        <translation>انظر ممّ تُحسب السرعة الجديدة.</translation>
    </message>
    <message>
        <source>The least came at the %1 with %2 m/s into it, the most at the %3 with %4 m/s.</source>
        <translation>أقلّها عاد عند ⁨%1⁩ بسرعة ⁦%2 m/s⁩ نحوه، وأكثرها عند ⁨%3⁩ بسرعة ⁦%4 m/s⁩.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who all of the speed back</source>
        <translation>التصادمات عند %walls تعيد إلى %who كل السرعة</translation>
    </message>
    <message>
        <source>At the %walls e acts on %who twice</source>
        <translation>عند %walls يؤثر e في %who مرتين</translation>
    </message>
    <message>
        <source>At the %walls the root of e acts on %who</source>
        <translation>عند %walls يؤثر جذر e في %who</translation>
    </message>
    <message>
        <source>Of the part along the normal nothing comes back.</source>
        <translation>لا يعود شيء من المركّبة الموازية للعمودي.</translation>
    </message>
    <message>
        <source>At the %walls 1 − e stands where e belongs, for %who</source>
        <translation>عند %walls يرد ⁦1 − e⁩ حيث مكان e، بالنسبة إلى %who</translation>
    </message>
    <message>
        <source>At the %walls 1 + e stands where e belongs, for %who</source>
        <translation>عند %walls يرد ⁦1 + e⁩ حيث مكان e، بالنسبة إلى %who</translation>
    </message>
    <message>
        <source>Hits at the %walls slow %who and turn nothing round</source>
        <translation>التصادمات عند %walls تبطئ %who ولا تعكس شيئًا</translation>
    </message>
    <message>
        <source>Here e is %1. </source>
        <translation>هنا e يساوي ⁨%1⁩. </translation>
    </message>
    <message>
        <source>walls</source>
        <comment>behind: at the</comment>
        <translation>الجدران</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>walls</comment>
        <extracomment>&quot;left wall, floor&quot; and &quot;ceiling&quot;</extracomment>
        <translation>%1 و%2</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and went on past it at first.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلها جاءت الدائرة ⁨%2⁩ إلى ⁨%3⁩ عند ⁦%4 m⁩ بسرعة ⁦%5 m/s⁩ ومضت أولًا إلى ما بعده.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s, circle %3 went on past it. Look at what your program asks for it, and whether the answer is ever yes.</source>
        <translation>قُذفت الدائرة ⁨%3⁩ نحو ⁨%1⁩ بسرعة ⁦%2 m/s⁩ فمضت إلى ما بعده. انظر ما الذي يسأله برنامجك عنه وهل يكون الجواب نعم أبدًا.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round too early</source>
        <translation>التصادمات عند %walls تردّ %who قبل الأوان</translation>
    </message>
    <message>
        <source>At the %walls the centre of %who is asked for, not the rim</source>
        <translation>عند %walls يُسأل عن مركز %who، لا عن الحافة</translation>
    </message>
    <message>
        <source>At the %walls the radius of another circle stands for that of %who</source>
        <translation>عند %walls يحل نصف قطر دائرة أخرى محل نصف قطر %who</translation>
    </message>
    <message>
        <source>At the %walls the larger radius stands for that of %who</source>
        <translation>عند %walls يحل نصف القطر الأكبر محل نصف قطر %who</translation>
    </message>
    <message>
        <source>At the %walls the smaller radius stands for that of %who</source>
        <translation>عند %walls يحل نصف القطر الأصغر محل نصف قطر %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round too late</source>
        <translation>التصادمات عند %walls تردّ %who متأخرة</translation>
    </message>
    <message>
        <source>At the %walls a number stands for the radius of %who</source>
        <translation>عند %walls يقوم عدد مقام نصف قطر %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round at the far side of the rim</source>
        <translation>التصادمات عند %walls تردّ %who عند الطرف البعيد من الحافة</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round a whole second too early</source>
        <translation>التصادمات عند %walls تردّ %who قبل الأوان بثانية كاملة</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round at the wrong place</source>
        <translation>التصادمات عند %walls تردّ %who في الموضع الخاطئ</translation>
    </message>
    <message>
        <source>Slow hits at the %walls give %who another share of the speed back</source>
        <translation>التصادمات البطيئة عند %walls تعيد إلى %who حصةً أخرى من السرعة</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and left it with %4 times that speed; %5 times is right, however slow it is.</source>
        <translation>جاءت الدائرة ⁨%1⁩ إلى ⁨%2⁩ بسرعة ⁦%3 m/s⁩ وغادرته بهذه السرعة مضروبةً في ⁨%4⁩؛ والصحيح في ⁨%5⁩ مهما كانت بطيئة.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who somewhere else</source>
        <translation>التصادمات عند %walls تضع %who في مكان آخر</translation>
    </message>
    <message>
        <source>At the %1 circle %4 was put %2 m away from its own path, at %3 m.</source>
        <translation>عند ⁨%1⁩ وُضعت الدائرة ⁨%4⁩ على بعد ⁦%2 m⁩ من مسارها، في ⁦%3 m⁩.</translation>
    </message>
    <message>
        <source>There the other circle was: each circle goes back to its *own* place.</source>
        <translation>هناك كانت الدائرة الأخرى: كل دائرة تعود إلى موضعها *هي*.</translation>
    </message>
    <message>
        <source>It belongs where its rim is at the wall, or back where it was before that step.</source>
        <translation>مكانها حيث تكون حافتها عند الجدار، أو حيث كانت قبل تلك الخطوة.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who further out</source>
        <translation>التصادمات عند %walls تضع %who أبعد إلى الخارج</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %5 would have come to %2 m from the wall and was put %3 m from it; its radius is %4 m. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>عند ⁨%1⁩ كان مركز الدائرة ⁨%5⁩ سيبلغ ⁦%2 m⁩ من الجدار فوُضع على بعد ⁦%3 m⁩ منه؛ ونصف قطرها ⁦%4 m⁩. ضعها حيث تكون حافتها عند الجدار، أو أعدها من حيث جاءت.</translation>
    </message>
    <message>
        <source>When circle %1 was %2 m from the %3 its velocity changed, and in the same step that of the other, far from it and from every wall. A wall turns the circle that touches it, and no other.</source>
        <translation>حين كانت الدائرة ⁨%1⁩ على بعد ⁦%2 m⁩ من ⁨%3⁩ تغيّرت سرعتها، وفي الخطوة نفسها سرعة الأخرى البعيدة عنها وعن كل جدار. الجدار يردّ الدائرة التي تلمسه ولا يردّ غيرها.</translation>
    </message>
    <message>
        <source>Hits at the %walls leave %who outside</source>
        <translation>التصادمات عند %walls تترك %who في الخارج</translation>
    </message>
    <message>
        <source>After the hit the rim of circle %1 is %2 m past the %3, and its velocity takes it back by %4 m a step: slower than it came, it is still outside after the next one. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>بعد التصادم تكون حافة الدائرة ⁨%1⁩ أبعد بمقدار ⁦%2 m⁩ خلف ⁨%3⁩، وسرعتها تعيدها ⁦%4 m⁩ في كل خطوة: وهي أبطأ مما جاءت، فتظل في الخارج بعد الخطوة التالية أيضًا. ضعها حيث تكون حافتها عند الجدار، أو أعدها من حيث جاءت.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who too far in</source>
        <translation>التصادمات عند %walls تضع %who أبعد إلى الداخل مما ينبغي</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %5 was %2 m from the wall before that step and was put %3 m from it; its radius is %4 m, so that there is a gap. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>عند ⁨%1⁩ كان مركز الدائرة ⁨%5⁩ على بعد ⁦%2 m⁩ من الجدار قبل تلك الخطوة فوُضع على بعد ⁦%3 m⁩ منه؛ ونصف قطرها ⁦%4 m⁩، فبقيت فجوة. ضعها حيث تكون حافتها عند الجدار، أو أعدها من حيث جاءت.</translation>
    </message>
    <message>
        <source>In the step in which circle %1 was answered by the %2, the other circle, far from every wall, did not go on freely: its place is %3 m and its velocity %4 m/s off. A wall acts on the circle that touches it, and on no other.</source>
        <translation>في الخطوة التي وقع فيها تصادم الدائرة ⁨%1⁩ مع ⁨%2⁩ لم تمض الدائرة الأخرى، البعيدة عن كل جدار، حرّة: موضعها بعيد بمقدار ⁦%3 m⁩ وسرعتها بمقدار ⁦%4 m/s⁩ عمّا ينبغي. الجدار يؤثر في الدائرة التي تلمسه ولا يؤثر في غيرها.</translation>
    </message>
    <message>
        <source>Circle %3 came with %1 m/s and left with %2 m/s. Both walls are hit in the same step, and each must turn its own part, whichever comes first.</source>
        <translation>جاءت الدائرة ⁨%3⁩ بسرعة ⁦%1 m/s⁩ وغادرت بسرعة ⁦%2 m/s⁩. يُصاب الجداران في الخطوة نفسها، وعلى كل منهما أن يعكس مركّبته، أيًّا كان الأول.</translation>
    </message>
    <message>
        <source>circle 1 came with %1 m/s, circle 2 with %2 m/s</source>
        <translation>جاءت الدائرة 1 بسرعة ⁦%1 m/s⁩ والدائرة 2 بسرعة ⁦%2 m/s⁩</translation>
    </message>
    <message>
        <source>near %1 m</source>
        <translation>قرب ⁦%1 m⁩</translation>
    </message>
    <message>
        <source>They touched, their places were changed and their velocities kept, until they moved apart.</source>
        <translation>تلامستا فتغير موضعاهما وبقيت سرعتاهما حتى ابتعدتا.</translation>
    </message>
    <message>
        <source>They ran into each other until their centres were %1 m apart, and were answered when that grew again.</source>
        <translation>تداخلتا حتى صار بين مركزيهما ⁦%1 m⁩، وجاءت الاستجابة حين عادت هذه المسافة تزداد.</translation>
    </message>
    <message>
        <source>Circles that come nearer have a positive closing speed (v₁ − v₂)·n, with n from 1 to 2: look at the comparison, and at which way your normal points.</source>
        <translation>الدائرتان اللتان تقتربان لهما سرعة اقتراب موجبة ⁦(v₁ − v₂)·n⁩ حيث n من 1 إلى 2: انظر إلى المقارنة وإلى الجهة التي يشير إليها الناظم.</translation>
    </message>
    <message>
        <source>circle 2 is to the right of circle 1</source>
        <translation>تكون الدائرة 2 إلى يمين الدائرة 1</translation>
    </message>
    <message>
        <source>circle 2 is to the left of circle 1</source>
        <translation>تكون الدائرة 2 إلى يسار الدائرة 1</translation>
    </message>
    <message>
        <source>circle 2 is above circle 1</source>
        <translation>تكون الدائرة 2 فوق الدائرة 1</translation>
    </message>
    <message>
        <source>circle 2 is below circle 1</source>
        <translation>تكون الدائرة 2 تحت الدائرة 1</translation>
    </message>
    <message>
        <source>circle %1 is at rest</source>
        <translation>تكون الدائرة ⁨%1⁩ ساكنة</translation>
    </message>
    <message>
        <source>circle %1 comes towards circle %2</source>
        <translation>تأتي الدائرة ⁨%1⁩ نحو الدائرة ⁨%2⁩</translation>
    </message>
    <message>
        <source>circle %1 moves away from circle %2</source>
        <translation>تبتعد الدائرة ⁨%1⁩ عن الدائرة ⁨%2⁩</translation>
    </message>
    <message>
        <source>circle %1 is the faster one along the line of centres</source>
        <translation>تكون الدائرة ⁨%1⁩ الأسرع على خط المركزين</translation>
    </message>
    <message>
        <source>circle %1 is the faster one</source>
        <translation>تكون الدائرة ⁨%1⁩ الأسرع</translation>
    </message>
    <message>
        <source>both move the same way along the line of centres</source>
        <translation>تتحرك كلتاهما في اتجاه واحد على خط المركزين</translation>
    </message>
    <message>
        <source>both come towards each other</source>
        <translation>تأتي كلتاهما نحو الأخرى</translation>
    </message>
    <message>
        <source>one of them is at rest</source>
        <translation>تكون إحداهما ساكنة</translation>
    </message>
    <message>
        <source>both are equally fast along the line of centres</source>
        <translation>تتساوى سرعتاهما على خط المركزين</translation>
    </message>
    <message>
        <source>both are equally fast</source>
        <translation>تتساوى سرعتاهما</translation>
    </message>
    <message>
        <source>circle %1 moves to the right</source>
        <translation>تتحرك الدائرة ⁨%1⁩ إلى اليمين</translation>
    </message>
    <message>
        <source>circle %1 moves to the left</source>
        <translation>تتحرك الدائرة ⁨%1⁩ إلى اليسار</translation>
    </message>
    <message>
        <source>circle %1 moves upward</source>
        <translation>تتحرك الدائرة ⁨%1⁩ إلى أعلى</translation>
    </message>
    <message>
        <source>circle %1 moves downward</source>
        <translation>تتحرك الدائرة ⁨%1⁩ إلى أسفل</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves to the right</source>
        <translation>تتحرك الدائرة 1، منظورًا إليها من الدائرة 2، إلى اليمين</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves to the left</source>
        <translation>تتحرك الدائرة 1، منظورًا إليها من الدائرة 2، إلى اليسار</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves upward</source>
        <translation>تتحرك الدائرة 1، منظورًا إليها من الدائرة 2، إلى أعلى</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves downward</source>
        <translation>تتحرك الدائرة 1، منظورًا إليها من الدائرة 2، إلى أسفل</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves away from (0, 0)</source>
        <translation>تبتعد الدائرة 1، منظورًا إليها من الدائرة 2، عن ⁦(0, 0)⁩</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves towards (0, 0)</source>
        <translation>تتحرك الدائرة 1، منظورًا إليها من الدائرة 2، نحو ⁦(0, 0)⁩</translation>
    </message>
    <message>
        <source>circle %1 is the larger one</source>
        <translation>تكون الدائرة ⁨%1⁩ الأكبر</translation>
    </message>
    <message>
        <source>circle %1 is the heavier one</source>
        <translation>تكون الدائرة ⁨%1⁩ الأثقل</translation>
    </message>
    <message>
        <source>circle %1 is the denser one</source>
        <translation>تكون الدائرة ⁨%1⁩ الأكثف</translation>
    </message>
    <message>
        <source>both are equally large</source>
        <translation>يتساوى حجماهما</translation>
    </message>
    <message>
        <source>both are equally heavy</source>
        <translation>تتساوى كتلتاهما</translation>
    </message>
    <message>
        <source>both are equally dense</source>
        <translation>تتساوى كثافتاهما</translation>
    </message>
    <message>
        <source>Circle 2 was hit, was back from the wall close behind it within a few steps and ran into circle 1 without an answer; from a wall farther off it gets one. What counts is whether they overlap and come nearer, not when the last hit was, nor whether a wall is near.</source>
        <translation>صُدمت الدائرة 2 وعادت من الجدار القريب خلفها في بضع خطوات ودخلت في الدائرة 1 بلا استجابة؛ ومن جدار أبعد تلقى استجابة. المهم هو هل تتداخلان وتقتربان، لا متى كان آخر تصادم ولا هل الجدار قريب.</translation>
    </message>
    <message>
        <source>Circle 2 was hit, came back from the wall behind it and ran through circle 1. What counts is whether they overlap and come nearer: look at what else is asked, and at what your program keeps of a hit.</source>
        <translation>صُدمت الدائرة 2 وعادت من الجدار خلفها واخترقت الدائرة 1. المهم هو هل تتداخلان وتقتربان: انظر إلى ما يُسأل عنه غير ذلك وإلى ما يحتفظ به برنامجك من التصادم.</translation>
    </message>
    <message>
        <source>In all these hits the new part of circle %1 along that line was %2 times that of circle 1 before the hit and %3 times that of circle 2; right is %4 and %5 times.</source>
        <translation>في كل هذه التصادمات كانت المركّبة الجديدة للدائرة ⁨%1⁩ على ذلك الخط تساوي مركّبة الدائرة 1 قبل التصادم مضروبةً في ⁨%2⁩ ومركّبة الدائرة 2 مضروبةً في ⁨%3⁩؛ الصواب ⁨%4⁩ و⁨%5⁩.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the radius</source>
        <translation>للدفع مقدار خاطئ يتوقف على نصف القطر</translation>
    </message>
    <message>
        <source>With r = %1 m for both the push is %2 times as large as it should be, with r = %3 m it is %4 times.</source>
        <translation>مع ⁦r = %1 m⁩ لكلتيهما الدفع يساوي ما يجب مضروبًا في ⁨%2⁩، ومع ⁦r = %3 m⁩ مضروبًا في ⁨%4⁩.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the circles</source>
        <translation>للدفع مقدار خاطئ يتوقف على الدائرتين</translation>
    </message>
    <message>
        <source>With r = %1 m and ρ = %2 for both the push is %3 times as large as it should be, with r = %4 m and ρ = %5 it is %6 times.</source>
        <translation>مع ⁦r = %1 m⁩ و⁦ρ = %2⁩ لكلتيهما الدفع يساوي ما يجب مضروبًا في ⁨%3⁩، ومع ⁦r = %4 m⁩ و⁦ρ = %5⁩ مضروبًا في ⁨%6⁩.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the timestep</source>
        <translation>للدفع مقدار خاطئ يتوقف على الخطوة الزمنية</translation>
    </message>
    <message>
        <source>With a timestep of %1 s the push is %2 times as large as it should be, and with %3 s about %4 times.</source>
        <translation>بخطوة زمنية ⁦%1 s⁩ الدفع يساوي ما يجب مضروبًا في ⁨%2⁩، وبخطوة ⁦%3 s⁩ مضروبًا في نحو ⁨%4⁩.</translation>
    </message>
    <message>
        <source>Only circle %1 leaves a hit as it should</source>
        <translation>الدائرة ⁨%1⁩ وحدها تغادر التصادم كما يجب</translation>
    </message>
    <message>
        <source>Hits at the %walls take the part of %who along the normal away</source>
        <translation>التصادمات عند %walls تأخذ مركّبة %who على امتداد الناظم</translation>
    </message>
    <message>
        <source>Some meetings are answered before they touch</source>
        <translation>تُقابَل بعض اللقاءات بالاستجابة قبل التلامس</translation>
    </message>
    <message>
        <source>Some meetings are answered too late</source>
        <translation>تُقابَل بعض اللقاءات بالاستجابة متأخرة</translation>
    </message>
    <message>
        <source>Circle %1 does not keep its part across in a hit</source>
        <translation>لا تحتفظ الدائرة ⁨%1⁩ بمركّبتها المعامدة في التصادم</translation>
    </message>
    <message>
        <source>From every start tried the two are at the same place one step later. Each circle has a place and a velocity of its own and goes on from those: look at what the lines for one take from the other.</source>
        <translation>من كل بداية جُرّبت تكون الاثنتان في الموضع نفسه بعد خطوة واحدة. لكل دائرة موضع وسرعة خاصان بها وتمضي منهما: انظر ماذا تأخذ أسطر الأولى من الأخرى.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and so it has from every other start tried. A step works the new velocity out from the one that the circle has, which a hit may have changed; a start is set once, in `on_load`.</source>
        <translation>من بداية بسرعة ⁦%1 m/s⁩ تكون السرعة بعد خطوة واحدة ⁦%2 m/s⁩، وهكذا من كل بداية أخرى جُرّبت. الخطوة تحسب السرعة الجديدة من سرعة الدائرة التي ربما غيّرها تصادم؛ أما البداية فتُضبط مرة واحدة، في ⁦`on_load`⁩.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and that part is the same from every other start tried. A step works each part out from the one that the circle has, and keeps it for the next.</source>
        <translation>من بداية بسرعة ⁦%1 m/s⁩ تكون السرعة بعد خطوة واحدة ⁦%2 m/s⁩، وتلك المركّبة هي نفسها من كل بداية أخرى جُرّبت. الخطوة تحسب كل مركّبة من التي للدائرة، وتحتفظ بها للخطوة التالية.</translation>
    </message>
    <message>
        <source>From every start tried the two are near each other one step later. Each circle goes on from its own place: look at the names in the line that moves it.</source>
        <translation>من كل بداية جُرّبت تصبح الدائرتان متقاربتين بعد خطوة واحدة. كل دائرة تمضي من موضعها هي: انظر إلى الأسماء في السطر الذي يحرّكها.</translation>
    </message>
    <message>
        <source>Look at what your program asks there, and at what it keeps from one step to the next.</source>
        <translation>انظر ما الذي يسأل عنه برنامجك هناك، وما الذي يحتفظ به من خطوة إلى أخرى.</translation>
    </message>
    <message>
        <source>With all radii tried they answer at the same distance, between %1 and %2 m.</source>
        <translation>مع كل أنصاف الأقطار التي جُرّبت تستجيبان عند المسافة نفسها، بين ⁨%1⁩ و⁦%2 m⁩.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time.</source>
        <translation>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، لم تأتِ الاستجابة في وقتها في أي لقاء.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في لقاء واحد.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في لقاءين.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في %n.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في %n.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>This one came out wrong: %1.</source>
        <translation>جاء هذا اللقاء خطأً: %1.</translation>
    </message>
    <message>
        <source>This one was answered in time: %1.</source>
        <translation>أُجيب عن هذا اللقاء في وقته: %1.</translation>
    </message>
    <message>
        <source>Look at what changes from one side to the other: the sign of a difference, or an angle.</source>
        <translation>انظر ما الذي يتغير من جهة إلى أخرى: إشارة فرق أو زاوية.</translation>
    </message>
    <message>
        <source>A hit is due where they overlap and come nearer along the line of centres, and nowhere else.</source>
        <translation>يحين التصادم حيث تتداخلان وتتقاربان على طول خط المركزين، لا في غير ذلك.</translation>
    </message>
    <message>
        <source>Some hits do not act along the line of centres</source>
        <translation>بعض التصادمات لا تؤثر على طول خط المركزين</translation>
    </message>
    <message>
        <source>Some hits of the two circles are answered too late</source>
        <translation>تُقابَل بعض تصادمات الدائرتين بالاستجابة متأخرة</translation>
    </message>
    <message>
        <source>Some hits of the two circles are not answered</source>
        <translation>بعض تصادمات الدائرتين تبقى بلا استجابة</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time and along the line of centres: %2.</source>
        <translation>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، لم تأتِ الاستجابة في وقتها وعلى طول خط المركزين في أي لقاء: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها وعلى طول خط المركزين في لقاء واحد: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها وعلى طول خط المركزين في لقاءين: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها وعلى طول خط المركزين في %n: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها وعلى طول خط المركزين في %n: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها وعلى طول خط المركزين في %n: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time: %2.</source>
        <translation>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، لم تأتِ الاستجابة في وقتها في أي لقاء: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في لقاء واحد: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في لقاءين: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في %n: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في %n: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في %n: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>their line of centres at %1°</source>
        <translation>وخط مركزيهما عند ⁦%1°⁩</translation>
    </message>
    <message>
        <source>At every timestep, gravity and velocity tried it goes on by %1 m besides. Look at what is added to the position.</source>
        <translation>مع كل ⁦Δt⁩ وكل جاذبية وكل سرعة جُرّبت يُضاف إليها ⁦%1 m⁩. انظر ماذا يُجمع إلى الموضع.</translation>
    </message>
    <message>
        <source>At every gravity and velocity tried it goes on by %1 m/s times Δt besides. Look at what is added to the position.</source>
        <translation>مع كل جاذبية وكل سرعة جُرّبت يُضاف ⁦%1 m/s⁩ مضروبًا في ⁦Δt⁩. انظر ماذا يُجمع إلى الموضع.</translation>
    </message>
    <message>
        <source>At every timestep tried gravity acts for %1 s. Take the parameter of `on_update`.</source>
        <translation>عند كل خطوة زمنية جُرّبت تؤثر الجاذبية مدة ⁦%1 s⁩. خذ معامل `on_update`.</translation>
    </message>
    <message>
        <source>At times gravity acts wrongly on %who</source>
        <translation>أحيانًا تؤثر الجاذبية في %who تأثيرًا خاطئًا</translation>
    </message>
    <message>
        <source>At times the velocity of %who changes wrongly</source>
        <translation>أحيانًا تتغير سرعة %who تغيّرًا خاطئًا</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, changed its velocity by %4 m/s in a step of %5 s; %6 m/s is right.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلها غيّرت الدائرة ⁨%2⁩، وهي عند ⁦%3 m⁩ لا تلمس شيئًا، سرعتها بمقدار ⁦%4 m/s⁩ في خطوة مدتها ⁦%5 s⁩؛ الصواب ⁦%6 m/s⁩.</translation>
    </message>
    <message>
        <source>At times the way of %who in a step is not v Δt</source>
        <translation>أحيانًا لا يكون مسار %who في خطوة v Δt</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, went %4 m in a step of %5 s; %6 m is right.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلها تقدمت الدائرة ⁨%2⁩، وهي عند ⁦%3 m⁩ لا تلمس شيئًا، ⁦%4 m⁩ في خطوة مدتها ⁦%5 s⁩؛ الصواب ⁦%6 m⁩.</translation>
    </message>
    <message>
        <source>At times the motion of %who is not %1</source>
        <translation>أحيانًا لا تكون حركة %who هي %1</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, went %4 m in a step of %5 s; by that method it is %6 m.</source>
        <translation>عند ⁦%1 s⁩ من تشغيلها تقدمت الدائرة ⁨%2⁩، وهي عند ⁦%3 m⁩ لا تلمس شيئًا، ⁦%4 m⁩ في خطوة مدتها ⁦%5 s⁩؛ وبتلك الطريقة تكون ⁦%6 m⁩.</translation>
    </message>
    <message>
        <source>the exact parabola</source>
        <translation>القطع المكافئ الدقيق</translation>
    </message>
    <message>
        <source>The acceleration of %who depends wrongly on the velocity</source>
        <translation>يتوقف تسارع %who على السرعة توقفًا خاطئًا</translation>
    </message>
    <message>
        <source>Far from everything the velocity of %who turns round</source>
        <translation>بعيدًا عن كل شيء تنعكس سرعة %who</translation>
    </message>
    <message>
        <source>%1, where circle %2 was</source>
        <translation>%1، حيث كانت الدائرة ⁨%2⁩</translation>
    </message>
    <message>
        <source>Some hits of the two circles come out wrong</source>
        <translation>بعض تصادمات الدائرتين تأتي خطأً</translation>
    </message>
    <message>
        <source>%1, for circle %2 alone</source>
        <translation>%1، للدائرة ⁨%2⁩ وحدها</translation>
    </message>
    <message>
        <source>With every e tried the rebound is that of e = %1.</source>
        <translation>مع كل e جُرّبت يكون الارتداد ارتداد ⁦e = %1⁩.</translation>
    </message>
    <message>
        <source>With every e tried circle 1 answers as with e = %1 and circle 2 as with e = %2.</source>
        <translation>مع كل e جُرّبت تستجيب الدائرة 1 كما مع ⁦e = %1⁩ والدائرة 2 كما مع ⁦e = %2⁩.</translation>
    </message>
    <message>
        <source>Two equal circles exchange their whole velocities</source>
        <translation>دائرتان متساويتان تتبادلان سرعتيهما كاملتين</translation>
    </message>
    <message>
        <source>After an elastic hit the circles do not part</source>
        <translation>بعد تصادم مرن لا تفترق الدائرتان</translation>
    </message>
    <message>
        <source>Along the line of centres, from 1 to 2, circle 1 came with %1 m/s and circle 2 with %2 m/s; they left with %3 and %4; %5 and %6 are right.</source>
        <translation>على طول خط المركزين، من 1 إلى 2، جاءت الدائرة 1 بسرعة ⁦%1 m/s⁩ والدائرة 2 بسرعة ⁦%2 m/s⁩؛ وغادرتا بسرعتي ⁦%3⁩ و⁦%4⁩؛ الصواب ⁦%5⁩ و⁦%6⁩.</translation>
    </message>
    <message>
        <source>Across the line of centres circle 1 came with %1 m/s and circle 2 with %2 m/s; they left with %3 and %4; %5 and %6 are right.</source>
        <translation>معامدًا لخط المركزين جاءت الدائرة 1 بسرعة ⁦%1 m/s⁩ والدائرة 2 بسرعة ⁦%2 m/s⁩؛ وغادرتا بسرعتي ⁦%3⁩ و⁦%4⁩؛ الصواب ⁦%5⁩ و⁦%6⁩.</translation>
    </message>
    <message>
        <source>of each circle in a run</source>
        <translation>لكل دائرة في التشغيل</translation>
    </message>
    <message>
        <source>of each circle at each wall in a run</source>
        <translation>لكل دائرة عند كل جدار في التشغيل</translation>
    </message>
    <message>
        <source>in a run</source>
        <translation>في التشغيل</translation>
    </message>
    <message>
        <source>all that came %1 s or more after the one before, none that came within %2 s</source>
        <translation>كل ما جاء بعد سابقه بـ ⁦%1 s⁩ أو أكثر، ولا شيء مما جاء بعده خلال ⁦%2 s⁩</translation>
    </message>
    <message>
        <source>all up to %1 s of a run, none from %2 s on</source>
        <translation>كلها حتى ⁦%1 s⁩ من التشغيل، ولا شيء منها ابتداءً من ⁦%2 s⁩</translation>
    </message>
    <message>
        <source>all from %1 s of a run on, none up to %2 s</source>
        <translation>كلها ابتداءً من ⁦%1 s⁩ من التشغيل، ولا شيء منها حتى ⁦%2 s⁩</translation>
    </message>
    <message>
        <source>all at y = %1 m and above, none at y = %2 m and below</source>
        <translation>كلها عند ⁦y = %1 m⁩ وفوقها، ولا شيء منها عند ⁦y = %2 m⁩ وتحتها</translation>
    </message>
    <message>
        <source>all at y = %1 m and below, none at y = %2 m and above</source>
        <translation>كلها عند ⁦y = %1 m⁩ وتحتها، ولا شيء منها عند ⁦y = %2 m⁩ وفوقها</translation>
    </message>
    <message>
        <source>all at x = %1 m and left of it, none at x = %2 m and right of it</source>
        <translation>كلها عند ⁦x = %1 m⁩ وإلى يسارها، ولا شيء منها عند ⁦x = %2 m⁩ وإلى يمينها</translation>
    </message>
    <message>
        <source>all at x = %1 m and right of it, none at x = %2 m and left of it</source>
        <translation>كلها عند ⁦x = %1 m⁩ وإلى يمينها، ولا شيء منها عند ⁦x = %2 m⁩ وإلى يسارها</translation>
    </message>
    <message>
        <source>all with up to %1 m/s, none with %2 m/s or more</source>
        <translation>كلها بسرعة لا تزيد على ⁦%1 m/s⁩، ولا شيء منها بسرعة ⁦%2 m/s⁩ أو أكثر</translation>
    </message>
    <message>
        <source>all with %1 m/s or more, none with up to %2 m/s</source>
        <translation>كلها بسرعة ⁦%1 m/s⁩ أو أكثر، ولا شيء منها بسرعة لا تزيد على ⁦%2 m/s⁩</translation>
    </message>
    <message>
        <source>all with up to %1 m/s into the wall, none with %2 m/s or more</source>
        <translation>كلها بسرعة نحو الجدار لا تزيد على ⁦%1 m/s⁩، ولا شيء منها بسرعة ⁦%2 m/s⁩ أو أكثر</translation>
    </message>
    <message>
        <source>all with %1 m/s or more into the wall, none with up to %2 m/s</source>
        <translation>كلها بسرعة نحو الجدار ⁦%1 m/s⁩ أو أكثر، ولا شيء منها بسرعة لا تزيد على ⁦%2 m/s⁩</translation>
    </message>
    <message>
        <source>all with up to %1 m/s along the wall, none with %2 m/s or more</source>
        <translation>كلها بسرعة على طول الجدار لا تزيد على ⁦%1 m/s⁩، ولا شيء منها بسرعة ⁦%2 m/s⁩ أو أكثر</translation>
    </message>
    <message>
        <source>all with %1 m/s or more along the wall, none with up to %2 m/s</source>
        <translation>كلها بسرعة على طول الجدار ⁦%1 m/s⁩ أو أكثر، ولا شيء منها بسرعة لا تزيد على ⁦%2 m/s⁩</translation>
    </message>
    <message>
        <source>the first %1, none of the later ones</source>
        <translation>الأول %1، ولا شيء مما بعده</translation>
    </message>
    <message>
        <source>all but the first %1</source>
        <translation>كلها عدا الأول %1</translation>
    </message>
    <message>
        <source>all up to number %1, none from number %2 on, counted %3</source>
        <translation>كلها حتى الرقم ⁨%1⁩، ولا شيء منها ابتداءً من الرقم ⁨%2⁩، بالعدّ %3</translation>
    </message>
    <message>
        <source>all from number %1 on, none up to number %2, counted %3</source>
        <translation>كلها ابتداءً من الرقم ⁨%1⁩، ولا شيء منها حتى الرقم ⁨%2⁩، بالعدّ %3</translation>
    </message>
    <message>
        <source>the first, the third and so on %1, none between them</source>
        <translation>الأول والثالث وهكذا %1، ولا شيء مما بينها</translation>
    </message>
    <message>
        <source>the second, the fourth and so on %1, none between them</source>
        <translation>الثاني والرابع وهكذا %1، ولا شيء مما بينها</translation>
    </message>
    <message>
        <source>all before the two circles had hit each other, none after it</source>
        <translation>كلها قبل أن تتصادم الدائرتان، ولا شيء منها بعد ذلك</translation>
    </message>
    <message>
        <source>all before the circles had hit a wall, none after it</source>
        <translation>كلها قبل أن تصطدم الدوائر بجدار، ولا شيء منها بعد ذلك</translation>
    </message>
    <message>
        <source>all after the circles had hit a wall, none before it</source>
        <translation>كلها بعد أن اصطدمت الدوائر بجدار، ولا شيء منها قبل ذلك</translation>
    </message>
    <message>
        <source>all that moved to the right, no others</source>
        <translation>كل ما كان يتحرك إلى اليمين، دون غيره</translation>
    </message>
    <message>
        <source>all that moved to the left, no others</source>
        <translation>كل ما كان يتحرك إلى اليسار، دون غيره</translation>
    </message>
    <message>
        <source>all that moved upward, no others</source>
        <translation>كل ما كان يتحرك إلى الأعلى، دون غيره</translation>
    </message>
    <message>
        <source>all that moved downward, no others</source>
        <translation>كل ما كان يتحرك إلى الأسفل، دون غيره</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right.</source>
        <translation>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، لم تصحّ أي محاولة.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت واحدة.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت اثنتان.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت %n.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت %n.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right: %2.</source>
        <translation>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، لم تصحّ أي محاولة: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت واحدة: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت اثنتان: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت %n: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت %n: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، صحّت %n: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Which of these counts, the tries do not show.</source>
        <translation>أيُّ ذلك هو المهم، لا تُظهره المحاولات.</translation>
    </message>
    <message>
        <source>With every e tried %1 of the speed comes back.</source>
        <translation>مع كل e جُرّبت يرجع ⁨%1⁩ من السرعة.</translation>
    </message>
    <message>
        <source>Hits at the %walls leave %who moving outward</source>
        <translation>بعد التصادمات عند %walls تظل الحركة نحو الخارج (%who)</translation>
    </message>
    <message>
        <source>With every e tried nothing of it is lost.</source>
        <translation>مع كل e جُرّبت لا يُفقد منها شيء.</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls are not answered</source>
        <translation>بعض تصادمات %who عند %walls تبقى بلا استجابة</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls come out wrong</source>
        <translation>بعض تصادمات %who عند %walls تأتي خطأً</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls are answered too late</source>
        <translation>بعض تصادمات %who عند %walls تُقابَل بالاستجابة متأخرة</translation>
    </message>
    <message>
        <source>This one came out right: circle %1 at %2 s, at the %3 at %4 m with %5 m/s.</source>
        <translation>وجاء هذا صحيحًا: الدائرة ⁨%1⁩ عند ⁦%2 s⁩، عند ⁨%3⁩ في ⁦%4 m⁩ بسرعة ⁦%5 m/s⁩.</translation>
    </message>
    <message>
        <source>At every wall %who went out</source>
        <translation>عند كل جدار خرجت %who</translation>
    </message>
    <message>
        <source>At the %walls %who went out</source>
        <translation>عند %walls خرجت %who</translation>
    </message>
    <message>
        <source>Slow hits at the %walls leave %who moving outward</source>
        <translation>بعد التصادمات البطيئة عند %walls تظل الحركة نحو الخارج (%who)</translation>
    </message>
    <message>
        <source>The x of %who does not change</source>
        <translation>لا يتغير x لدى %who</translation>
    </message>
    <message>
        <source>The x of %who changes without its velocity</source>
        <translation>يتغير x لدى %who دون سرعتها</translation>
    </message>
    <message>
        <source>The y of %who does not change</source>
        <translation>لا يتغير y لدى %who</translation>
    </message>
    <message>
        <source>The y of %who changes without its velocity</source>
        <translation>يتغير y لدى %who دون سرعتها</translation>
    </message>
    <message>
        <source>At every timestep tried it goes as far as in %1 s. Take the parameter of `on_update`.</source>
        <translation>عند كل خطوة زمنية جُرّبت تقطع ما يُقطع في ⁦%1 s⁩. خذ معامل `on_update`.</translation>
    </message>
    <message>
        <source>The velocity has no part in the way of %who</source>
        <translation>لا دخل للسرعة في مسار %who</translation>
    </message>
    <message>
        <source>Along the normal only circle 1 feels e</source>
        <translation>على الناظم لا يؤثر e إلا في الدائرة 1</translation>
    </message>
    <message>
        <source>Along the normal only circle 2 feels e</source>
        <translation>على الناظم لا يؤثر e إلا في الدائرة 2</translation>
    </message>
    <message>
        <source>Not every hit stops both circles</source>
        <translation>ليس كل تصادم يوقف كلتا الدائرتين</translation>
    </message>
    <message>
        <source>Equal circles answer rightly, not all unequal ones do</source>
        <translation>الدائرتان المتساويتان تستجيبان استجابة صحيحة، لا كل دائرتين مختلفتين</translation>
    </message>
    <message>
        <source>Equal circles answer rightly, no unequal ones tried do</source>
        <translation>الدائرتان المتساويتان تستجيبان استجابة صحيحة، ولا تستجيب كذلك أي دائرتين مختلفتين جُرّبتا</translation>
    </message>
    <message>
        <source>all while another circle moved to the right, no others</source>
        <translation>كل ما كانت دائرة أخرى تتحرك أثناءه إلى اليمين، ولا غيره</translation>
    </message>
    <message>
        <source>all while another circle moved to the left, no others</source>
        <translation>كل ما كانت دائرة أخرى تتحرك أثناءه إلى اليسار، ولا غيره</translation>
    </message>
    <message>
        <source>all while another circle moved upward, no others</source>
        <translation>كل ما كانت دائرة أخرى تتحرك أثناءه إلى الأعلى، ولا غيره</translation>
    </message>
    <message>
        <source>all while another circle moved downward, no others</source>
        <translation>كل ما كانت دائرة أخرى تتحرك أثناءه إلى الأسفل، ولا غيره</translation>
    </message>
    <message>
        <source>In the step of a hit at the %walls gravity does not act on %who</source>
        <translation>في خطوة التصادم عند %walls لا تؤثر الجاذبية في %who</translation>
    </message>
    <message>
        <source>In a step of %1 s gravity changes the velocity by %2 m/s, in the step of a hit, too. When circle %4 was turned at the %3, the part along the wall stayed as it was before the step.</source>
        <translation>في خطوة مدتها ⁦%1 s⁩ تغيّر الجاذبية السرعة بمقدار ⁦%2 m/s⁩، في خطوة التصادم أيضًا. وحين ارتدت الدائرة ⁨%4⁩ عند ⁨%3⁩ بقيت المركّبة الموازية للجدار كما كانت قبل الخطوة.</translation>
    </message>
    <message>
        <source>At the %walls the parts of the velocity of %who are mixed up</source>
        <translation>عند %walls اختلطت مركّبتا سرعة %who</translation>
    </message>
    <message>
        <source>The part into the wall is turned round, the part along it stays: look at which part stands where.</source>
        <translation>المركّبة المتجهة إلى الجدار تنعكس، والموازية له تبقى: انظر أيّ مركّبة ترد في أيّ موضع.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 times the whole velocity back</source>
        <translation>التصادمات عند %walls تعيد إلى %who السرعة كلها مضروبةً في ⁨%1⁩</translation>
    </message>
    <message>
        <source>At the %walls the place of circle %1 is asked for, not that of %who</source>
        <translation>عند %walls يُسأل عن موضع الدائرة ⁨%1⁩، لا عن موضع %who</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s, circle %3 went on past it. In the middle its velocity changed from %4 to %5 m/s, with circle %6 beyond that wall. Look at whose place stands in the question.</source>
        <translation>قُذفت الدائرة ⁨%3⁩ نحو ⁨%1⁩ بسرعة ⁦%2 m/s⁩ فمضت إلى ما بعده. وفي الوسط تغيّرت سرعتها من ⁨%4⁩ إلى ⁦%5 m/s⁩ والدائرة ⁨%6⁩ وراء ذلك الجدار. انظر موضع أيّ دائرة يرد في السؤال.</translation>
    </message>
    <message>
        <source>Some hits at the %walls turn %who round too early</source>
        <translation>بعض التصادمات عند %walls تردّ %who قبل الأوان</translation>
    </message>
    <message>
        <source>Some hits at the %walls turn %who round too late</source>
        <translation>بعض التصادمات عند %walls تردّ %who متأخرة</translation>
    </message>
    <message>
        <source>Of %1 hits tried there, %2 came at the rim.</source>
        <translation>من بين ⁨%1⁩ تصادمات مجرّبة هناك، عند الحافة: ⁨%2⁩.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 and %5 m from the wall. It should turn when its rim is there.</source>
        <translation>نصف قطر الدائرة ⁨%1⁩ هو ⁦%2 m⁩، وعند ⁨%3⁩ جاء الارتداد حين كان مركزها بين ⁨%4⁩ و⁦%5 m⁩ من الجدار. يجب أن ترتد حين تكون حافتها هناك.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 m past the wall and %5 m short of it. It should turn when its rim is there.</source>
        <translation>نصف قطر الدائرة ⁨%1⁩ هو ⁦%2 m⁩، وعند ⁨%3⁩ جاء الارتداد حين كان مركزها بين ⁦%4 m⁩ وراء الجدار و⁦%5 m⁩ قبله. يجب أن ترتد حين تكون حافتها هناك.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 and %5 m past the wall. It should turn when its rim is there.</source>
        <translation>نصف قطر الدائرة ⁨%1⁩ هو ⁦%2 m⁩، وعند ⁨%3⁩ جاء الارتداد حين كان مركزها بين ⁨%4⁩ و⁦%5 m⁩ وراء الجدار. يجب أن ترتد حين تكون حافتها هناك.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who back to the start of the run</source>
        <translation>التصادمات عند %walls تعيد %who إلى حيث بدأ التشغيل</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %3 was put %2 m from the wall, as far as it was when the run began. The old place is that before the step: keep it anew in every step.</source>
        <translation>عند ⁨%1⁩ وُضع مركز الدائرة ⁨%3⁩ على بعد ⁦%2 m⁩ من الجدار، كما كان عند بدء التشغيل. الموضع القديم هو ما قبل الخطوة: احفظه من جديد في كل خطوة.</translation>
    </message>
    <message>
        <source>Of the %1 meetings that were tried %2 were answered in time; in %3 no velocity was changed.</source>
        <translation>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة في وقتها في ⁨%2⁩، ولم تتغيّر أي سرعة في ⁨%3⁩.</translation>
    </message>
    <message>
        <source>Some meetings are answered before they touch, others too late</source>
        <translation>تُقابَل بعض اللقاءات بالاستجابة قبل التلامس، وأخرى متأخرة</translation>
    </message>
    <message>
        <source>A distance is the root of the sum of the squares of both differences.</source>
        <translation>المسافة هي جذر مجموع مربعي الفرقين.</translation>
    </message>
    <message>
        <source>The circles are compared in x alone</source>
        <translation>تُقارَن الدائرتان في x وحدها</translation>
    </message>
    <message>
        <source>The circles are compared in y alone</source>
        <translation>تُقارَن الدائرتان في y وحدها</translation>
    </message>
    <message>
        <source>|Δx + Δy| is not the distance</source>
        <translation>⁦|Δx + Δy|⁩ ليس المسافة</translation>
    </message>
    <message>
        <source>In your own scene the circles answer before they touch</source>
        <translation>في مشهدك تستجيب الدائرتان قبل أن تتلامسا</translation>
    </message>
    <message>
        <source>In your own scene the circles answer too late</source>
        <translation>في مشهدك تستجيب الدائرتان متأخرتين</translation>
    </message>
    <message>
        <source>The distance of the centres comes into the push</source>
        <translation>يدخل بُعد المركزين في الدفع</translation>
    </message>
    <message>
        <source>Where an angle is used: x is its cosine and y its sine, and `math.atan` takes y first, then x.</source>
        <translation>حيث تُستعمل زاوية: x جيب تمامها وy جيبها، و⁦`math.atan`⁩ تأخذ y أولًا ثم x.</translation>
    </message>
    <message>
        <source>e is less than 1</source>
        <translation>يكون e أصغر من 1</translation>
    </message>
    <message>
        <source>e is 1</source>
        <translation>يكون e مساويًا 1</translation>
    </message>
    <message>
        <source>all with circle %1 at up to %2 m/s, none with it at %3 m/s or more</source>
        <translation>كل ما كانت فيه سرعة الدائرة ⁨%1⁩ حتى ⁦%2 m/s⁩، ولا واحد بلغت فيه ⁦%3 m/s⁩ أو أكثر</translation>
    </message>
    <message>
        <source>all with circle %1 at %2 m/s or more, none with it at up to %3 m/s</source>
        <translation>كل ما كانت فيه سرعة الدائرة ⁨%1⁩ ⁦%2 m/s⁩ أو أكثر، ولا واحد كانت فيه حتى ⁦%3 m/s⁩</translation>
    </message>
    <message>
        <source>all up to %1 m from (0, 0), none from %2 m on</source>
        <translation>كلها حتى ⁦%1 m⁩ من ⁦(0, 0)⁩، ولا شيء ابتداءً من ⁦%2 m⁩</translation>
    </message>
    <message>
        <source>all from %1 m from (0, 0) on, none up to %2 m</source>
        <translation>كلها ابتداءً من ⁦%1 m⁩ عن ⁦(0, 0)⁩، ولا شيء حتى ⁦%2 m⁩</translation>
    </message>
    <message>
        <source>Circles that come nearer fast are not answered</source>
        <translation>الدائرتان اللتان تقتربان بسرعة لا تلقيان استجابة</translation>
    </message>
    <message>
        <source>Not every meeting is answered</source>
        <translation>لا يلقى كل لقاء استجابة</translation>
    </message>
    <message>
        <source>Near %1 m circle 1 came with %2 m/s and circle 2 with %3 m/s, and they ran into each other; elsewhere others are answered. What counts is whether they overlap and come nearer.</source>
        <translation>قرب ⁦%1 m⁩ جاءت الدائرة 1 بسرعة ⁦%2 m/s⁩ والدائرة 2 بسرعة ⁦%3 m/s⁩ وتداخلتا؛ وفي مواضع أخرى تلقى لقاءات أخرى استجابة. المهم هل تتداخلان وتتقاربان.</translation>
    </message>
    <message>
        <source>Look at which masses and which signs stand in what is worked out for the other one.</source>
        <translation>انظر أي كتل وأي إشارات تدخل في ما يُحسب للأخرى.</translation>
    </message>
    <message>
        <source>No hit that was tried comes out right</source>
        <translation>لا تصحّ نتيجة أي من التصادمات المجرّبة</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right: %2.</source>
        <translation>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، لم يصحّ أي تصادم: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ تصادم واحد: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ تصادمان: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ منها %n: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ منها %n: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ منها %n: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right.</source>
        <translation>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، لم يصحّ أي تصادم.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ تصادم واحد.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ تصادمان.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ منها %n.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ منها %n.</numerusform>
            <numerusform>من التصادمات المجرّبة، وعددها ⁨%1⁩، صحّ منها %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried with e = %2, %n came out right: %3.</source>
        <translation>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، لم يصحّ أي تصادم: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ تصادم واحد: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ تصادمان: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n: %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried with e = %2, %n came out right.</source>
        <translation>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، لم يصحّ أي تصادم.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ تصادم واحد.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ تصادمان.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n.</numerusform>
            <numerusform>من التصادمات المجرّبة مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>In your own scene the first hit comes out right.</source>
        <translation>في مشهدك تصحّ نتيجة التصادم الأول.</translation>
    </message>
    <message>
        <source>In all hits that were tried circle 2 was at rest.</source>
        <translation>في كل التصادمات المجرّبة كانت الدائرة 2 ساكنة.</translation>
    </message>
    <message>
        <source>With e = %1 it comes out right.</source>
        <translation>مع ⁦e = %1⁩ تصحّ النتيجة.</translation>
    </message>
    <message>
        <source>A step exchanges x and y in the place of %who</source>
        <translation>الخطوة تبادل بين x وy في موضع %who</translation>
    </message>
    <message>
        <source>A step takes y for x in the place of %who</source>
        <translation>الخطوة تأخذ y مكان x في موضع %who</translation>
    </message>
    <message>
        <source>A step takes x for y in the place of %who</source>
        <translation>الخطوة تأخذ x مكان y في موضع %who</translation>
    </message>
    <message>
        <source>Each part of the place goes on from itself: look at which part stands where.</source>
        <translation>كل مركّبة من الموضع تنطلق من نفسها: انظر أي مركّبة تقف في أي مكان.</translation>
    </message>
    <message>
        <source>Every step puts %who at the same place</source>
        <translation>كل خطوة تضع %who في الموضع نفسه</translation>
    </message>
    <message>
        <source>Every step puts %who at the same x</source>
        <translation>كل خطوة تضع %who عند قيمة x نفسها</translation>
    </message>
    <message>
        <source>Every step puts %who at the same y</source>
        <translation>كل خطوة تضع %who عند قيمة y نفسها</translation>
    </message>
    <message>
        <source>Started at %1 m with %2 m/s, it is at %3 m one step of %4 s later.</source>
        <translation>من بداية عند ⁦%1 m⁩ بسرعة ⁦%2 m/s⁩ تكون الدائرة بعد خطوة واحدة من ⁦%4 s⁩ عند ⁦%3 m⁩.</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), circle %8 leaves as if m₂/m₁ were %5; %6 is right.</source>
        <translation>مع ⁦r₁ = %1⁩ و⁦r₂ = %2 m⁩، و⁦ρ₁ = %3⁩ و⁦ρ₂ = %4⁩ (و⁦e = %7⁩)، تمضي الدائرة ⁨%8⁩ كأن ⁦m₂/m₁ = %5⁩؛ الصواب ⁨%6⁩.</translation>
    </message>
    <message>
        <source>e multiplies the whole velocity of circle %1 after the hit</source>
        <translation>تُضرب سرعة الدائرة ⁨%1⁩ كاملة في e بعد التصادم</translation>
    </message>
    <message>
        <source>e belongs to the rebound along the line of centres alone.</source>
        <translation>المعامل e يخص الارتداد على خط المركزين وحده.</translation>
    </message>
    <message>
        <source>Both new velocities come from those *before* the hit: look at what each circle gets, and whether it is read before or after a velocity is written.</source>
        <translation>السرعتان الجديدتان كلتاهما تأتيان من السرعتين *قبل* التصادم: انظر ماذا تنال كل دائرة، وهل يُقرأ قبل كتابة سرعة أم بعدها.</translation>
    </message>
    <message>
        <source>So it is when the run begins. With that e a right program fails the check “%1”, too.</source>
        <translation>هكذا هو عند بدء التشغيل. وبهذا المعامل e لا يجتاز حتى برنامج صحيح الفحص «⁨%1⁩».</translation>
    </message>
    <message>
        <source>%1 (in some hits)</source>
        <translation>%1 (في بعض التصادمات)</translation>
    </message>
    <message>
        <source>%1 (equal circles)</source>
        <translation>%1 (دائرتان متساويتان)</translation>
    </message>
    <message>
        <source>The distance is taken between places of two moments

Both circles flew with %1 m/s along the line of centres, the one behind %2 m/s faster: where circle 2 was ahead, they answered with the centres %3 m apart, where circle 1 was, %4 m; rims touch at %5 m. The two differ from that by what a circle flies in a step: look at whether both places are of the same moment, after both have moved.</source>
        <translation>تؤخذ المسافة بين موضعين من لحظتين

طارت الدائرتان بسرعة ⁦%1 m/s⁩ على خط المركزين، والخلفية أسرع بمقدار ⁦%2 m/s⁩: حين كانت الدائرة 2 في المقدمة استجابتا والمركزان على بعد ⁦%3 m⁩، وحين كانت الدائرة 1 فعلى بعد ⁦%4 m⁩؛ تتلامس الحافتان عند ⁦%5 m⁩. كلاهما يختلف عن ذلك بما تقطعه دائرة في خطوة: انظر هل الموضعان من اللحظة نفسها، بعد أن تحركت الدائرتان.</translation>
    </message>
    <message>
        <source>Every step moves %who on from the place of the start</source>
        <translation>كل خطوة تحرّك %who من موضع البداية</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it is %2 m from its start after the first step of %3 s, and %4 m after the second. The way of a step is added to the place before that step: is the old place kept anew in every step?</source>
        <translation>إذا بدأت بسرعة ⁦%1 m/s⁩ كانت على بُعد ⁦%2 m⁩ من بدايتها بعد الخطوة الأولى ومدتها ⁦%3 s⁩، وعلى بُعد ⁦%4 m⁩ بعد الثانية. تُضاف مسافة الخطوة إلى الموضع الذي قبلها: فهل يُحفظ الموضع القديم من جديد في كل خطوة؟</translation>
    </message>
    <message>
        <source>Gravity on %who is divided by the timestep</source>
        <translation>تُقسم الجاذبية على %who على الخطوة الزمنية</translation>
    </message>
    <message>
        <source>An acceleration times a time is a velocity. Look at what stands before the timestep in the line that changes the velocity.</source>
        <translation>التسارع مضروبًا في الزمن سرعة. انظر ماذا يسبق الخطوة الزمنية في السطر الذي يغيّر السرعة.</translation>
    </message>
    <message>
        <source>Not every step of %who is made alike</source>
        <translation>ليست كل خطوات %who متماثلة</translation>
    </message>
    <message>
        <source>A step or two later it is as at the start again. Look at what your program counts, or keeps from one step to the next.</source>
        <translation>بعد خطوة أو خطوتين يعود الأمر كما في البداية. انظر ما الذي يعدّه برنامجك أو يحتفظ به من خطوة إلى التالية.</translation>
    </message>
    <message>
        <source>Only the first step changes the velocity of %who rightly</source>
        <translation>الخطوة الأولى وحدها تغيّر سرعة %who كما يجب</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, it has %2 m/s one step of %3 s later, which is right; in the next step that changes by %4 m/s, and gravity gives it %5 m/s. Look at which velocity the line that changes it goes on from, and at what your program keeps from one step to the next.</source>
        <translation>إذا رُميت بسرعة ⁦%1 m/s⁩ كانت سرعتها ⁦%2 m/s⁩ بعد خطوة مدتها ⁦%3 s⁩، وهذا صحيح؛ وفي الخطوة التالية تتغيّر بمقدار ⁦%4 m/s⁩ والجاذبية تعطيها ⁦%5 m/s⁩. انظر من أي سرعة ينطلق السطر الذي يغيّرها، وما الذي يحتفظ به برنامجك من خطوة إلى التالية.</translation>
    </message>
    <message>
        <source>Let go at rest, it has %1 m/s one step of %2 s later, far from every wall and every other circle; gravity gives it %3 m/s in a step. Thrown with %4 m/s it goes on as it should.</source>
        <translation>إذا تُركت ساكنةً كانت سرعتها ⁦%1 m/s⁩ بعد خطوة مدتها ⁦%2 s⁩، بعيدةً عن كل جدار وكل دائرة أخرى؛ والجاذبية تعطيها ⁦%3 m/s⁩ في الخطوة. وإذا رُميت بسرعة ⁦%4 m/s⁩ تابعت كما يجب.</translation>
    </message>
    <message>
        <source>e changes the velocity of %who away from any hit</source>
        <translation>يغيّر ⁦e⁩ سرعة %who بعيدًا عن أي تصادم</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s two steps of %3 s later with e = %4, and %5 m/s with e = 1; nothing is near. e belongs to hits alone: look at what is asked before the line that takes it.</source>
        <translation>إذا بدأت بسرعة ⁦%1 m/s⁩ كانت سرعتها بعد خطوتين مدة كل منهما ⁦%3 s⁩ مع ⁦e = %4⁩ هي ⁦%2 m/s⁩ ومع ⁦e = 1⁩ هي ⁦%5 m/s⁩؛ ولا شيء قريب. ⁦e⁩ للتصادمات وحدها: انظر ما الذي يُسأل قبل السطر الذي يأخذه.</translation>
    </message>
    <message>
        <source>With some timesteps the way of %who is not v Δt</source>
        <translation>مع بعض الخطوات الزمنية ليست مسافة %who هي ⁦v&#xa0;Δt⁩</translation>
    </message>
    <message>
        <source>With Δt = %1 s it goes v Δt. Look at which Δt the line that changes the position takes.</source>
        <translation>مع ⁦Δt = %1 s⁩ تكون المسافة ⁦v&#xa0;Δt⁩. انظر أي ⁦Δt⁩ يأخذ السطر الذي يغيّر الموضع.</translation>
    </message>
    <message>
        <source>Let go at rest, it goes as it should.</source>
        <translation>إذا تُركت ساكنةً تحركت كما يجب.</translation>
    </message>
    <message>
        <source>The way of %who in a step is wrong</source>
        <translation>مسافة %who في الخطوة خاطئة</translation>
    </message>
    <message>
        <source>The way of %who is divided by the timestep</source>
        <translation>مسافة %who تُقسم على الخطوة الزمنية</translation>
    </message>
    <message>
        <source>A velocity times a time is a length. Look at what stands before the timestep in the line that moves it.</source>
        <translation>السرعة مضروبةً في الزمن طول. انظر ماذا يسبق الخطوة الزمنية في السطر الذي يحرّك الدائرة.</translation>
    </message>
    <message>
        <source>The velocity of %who gets %1 times what gravity gives</source>
        <translation>سرعة %who تأخذ ⁨%1⁩ مرة مما تعطيه الجاذبية</translation>
    </message>
    <message>
        <source>From every speed tried it has %1 m/s along the normal afterwards: work the new velocity out from the old one.</source>
        <translation>من كل سرعة جُرّبت تكون لها بعد ذلك ⁦%1 m/s⁩ على العمودي: احسب السرعة الجديدة من القديمة.</translation>
    </message>
    <message>
        <source>Started at rest at two places, it is at one and the same place two steps later. A step *adds* a way to the old position.</source>
        <translation>من بدايتين ساكنتين في موضعين تكون الدائرة بعد خطوتين في موضع واحد بعينه. الخطوة *تضيف* مسافة إلى الموضع القديم.</translation>
    </message>
    <message>
        <source>%1 (in most hits)</source>
        <translation>⁨%1⁩ (في معظم التصادمات)</translation>
    </message>
    <message>
        <source>The circles do not stop in a hit</source>
        <translation>لا تتوقف الدائرتان في التصادم</translation>
    </message>
    <message>
        <source>Each circle keeps its direction and gets the other&apos;s speed</source>
        <translation>تحتفظ كل دائرة باتجاهها وتأخذ مقدار سرعة الأخرى</translation>
    </message>
    <message>
        <source>A velocity has a direction, too: what changes hands is the whole part along the line of centres, not its length.</source>
        <translation>للسرعة اتجاه أيضًا: ما يُتبادل هو المركّبة كاملةً على خط المركزين لا مقدارها.</translation>
    </message>
    <message>
        <source>Thrown at each of them, %who went on through it; at the %1 with %2 m/s. Look at whether your program asks about walls for %who, and whether the answer is ever yes.</source>
        <translation>قُذفت نحو كل جدار فنفذت منه %who؛ عند ⁨%1⁩ بسرعة ⁦%2 m/s⁩. انظر هل يسأل برنامجك عن الجدران لأجل %who وهل يكون الجواب نعم أبدًا.</translation>
    </message>
    <message>
        <source>In its first %1 s their rims come no nearer than %2 m, at %3 s. Look at the positions and velocities that they start with.</source>
        <translation>في أول ⁦%1 s⁩ منه لا تقترب حافتاهما إلى أقل من ⁦%2 m⁩، وذلك عند ⁦%3 s⁩. انظر إلى المواضع والسرعات التي تبدآن بها.</translation>
    </message>
    <message>
        <source>The circles of your scene do not meet in its first %1 s</source>
        <translation>لا تلتقي دائرتا مشهدك في أول ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>Circle %5 came to the %1 with %2 m/s and has %3 m/s after the hit, still into it; %4 m/s is right.</source>
        <translation>جاءت الدائرة ⁨%5⁩ إلى ⁨%1⁩ بسرعة ⁦%2 m/s⁩ وسرعتها بعد التصادم ⁦%3 m/s⁩ وما زالت نحو الخارج؛ الصواب ⁦%4 m/s⁩.</translation>
    </message>
    <message>
        <source>However it is started, what it has one step later comes from the velocity of circle %1: started with %2 m/s, it has %3 m/s. Each circle goes on from its own velocity: look at the names in the line that changes it.</source>
        <translation>كيفما كانت البداية تأتي السرعة بعد خطوة واحدة من سرعة الدائرة ⁨%1⁩: من ⁦%2 m/s⁩ في البداية إلى ⁦%3 m/s⁩. كل دائرة تنطلق من سرعتها هي: انظر إلى الأسماء في السطر الذي يغيّرها.</translation>
    </message>
    <message>
        <source>A step *adds* a way to the old position: look at the lines that put it there, and at what is asked before them.</source>
        <translation>الخطوة *تضيف* مسافة إلى الموضع القديم: انظر إلى الأسطر التي تضعها هناك، وإلى ما يُسأل قبلها.</translation>
    </message>
    <message>
        <source>No hit tried is answered but that of your own scene</source>
        <translation>لم يلقَ استجابةً من التصادمات المجرّبة إلا تصادم مشهدك</translation>
    </message>
    <message>
        <source>The circles are answered much too late, or not at all</source>
        <translation>تأتي الاستجابة للدائرتين متأخرة كثيرًا أو لا تأتي</translation>
    </message>
    <message>
        <source>A hit puts the circles too far apart</source>
        <translation>يضع التصادم الدائرتين متباعدتين أكثر مما يجب</translation>
    </message>
    <message>
        <source>They came until their centres were %1 m apart, and the step with the answer put them %2 m apart; rims touch at %3 m. It is enough that they touch: look at how far each of the two is moved.</source>
        <translation>اقتربتا حتى صارت المسافة بين المركزين ⁦%1 m⁩ ثم جعلتها خطوة الاستجابة ⁦%2 m⁩؛ تتلامس الحافتان عند ⁦%3 m⁩. يكفي أن تتلامسا: انظر كم تُزاح كل منهما.</translation>
    </message>
    <message>
        <source>A hit stops the x parts alone</source>
        <translation>لا يوقف التصادم إلا مركّبتي ⁦x⁩</translation>
    </message>
    <message>
        <source>A hit stops the y parts alone</source>
        <translation>لا يوقف التصادم إلا مركّبتي ⁦y⁩</translation>
    </message>
    <message>
        <source>The floor does not hold circle %1 up

Here e is %4. After %2 s near the floor its rim is %3 m below it, and deeper than before: the floor changes its velocity, and yet gravity pulls it on. Put the circle back where it touches.</source>
        <translation>الأرضية لا تحمل الدائرة ⁨%1⁩

هنا e يساوي ⁨%4⁩. بعد ⁦%2 s⁩ قرب الأرضية صارت حافتها تحتها بمقدار ⁦%3 m⁩، وأعمق مما كانت: الأرضية تغيّر سرعتها ومع ذلك تجذبها الجاذبية. أعد الدائرة إلى حيث تلمس.</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the acceleration is %2 m/s², and %3 m/s² under %4 m/s².</source>
        <translation>تحت الجاذبية ⁦%1 m/s²⁩ يكون التسارع ⁦%2 m/s²⁩، ويكون ⁦%3 m/s²⁩ تحت ⁦%4 m/s²⁩.</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the way of a step is %2, with v from before it.</source>
        <translation>تحت الجاذبية ⁦%1 m/s²⁩ تكون مسافة الخطوة ⁦%2⁩، وv هي السرعة قبلها.</translation>
    </message>
    <message>
        <source>Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods (Verlet, Runge-Kutta 4) ½ g Δt²; one of these is asked for.</source>
        <translation>أويلر لا تضيف شيئًا إلى ⁦v Δt⁩، وأويلر التماثلية تضيف ⁦g Δt²⁩، والطرائق الدقيقة (Verlet و Runge-Kutta 4) ⁦½ g Δt²⁩؛ والمطلوب واحدة من هذه.</translation>
    </message>
    <message>
        <source>Euler moves by the velocity from before the step alone.</source>
        <translation>أويلر تحرّك بالسرعة التي قبل الخطوة وحدها.</translation>
    </message>
    <message>
        <source>Symplectic Euler changes the velocity first and moves by the new one, which is v Δt + g Δt².</source>
        <translation>أويلر التماثلية تغيّر السرعة أولًا وتحرّك بالجديدة، وهذا ⁦v Δt + g Δt²⁩.</translation>
    </message>
    <message>
        <source>%1 is asked for.</source>
        <translation>المطلوب ⁦%1⁩.</translation>
    </message>
    <message>
        <source>The sign of ½ g Δt² is wrong in the motion of %who</source>
        <translation>إشارة ⁦½ g Δt²⁩ خاطئة في حركة %who</translation>
    </message>
    <message>
        <source>The circles have each other&apos;s method

Under gravity the way of circle 1 in a step is %1, that of circle 2 %2; it should be the other way round. Look at which circle goes with which method.</source>
        <translation>كلٌّ من الدائرتين لها طريقة الأخرى

تحت الجاذبية تكون مسافة الدائرة 1 في الخطوة ⁦%1⁩، ومسافة الدائرة 2 ⁦%2⁩؛ ويجب أن يكون العكس. انظر أيّ دائرة تسير بأي طريقة.</translation>
    </message>
    <message>
        <source>The circles move by different methods

Under gravity circle 1 moves by %1, with the way %2 in a step, and circle 2 by %3, with %4; both need the same. Look at which lines move which circle.</source>
        <translation>تتحرك الدائرتان بطريقتين مختلفتين

تحت الجاذبية تتحرك الدائرة 1 بطريقة ⁨%1⁩ والمسافة في الخطوة ⁦%2⁩، والدائرة 2 بطريقة ⁨%3⁩ والمسافة ⁦%4⁩؛ وكلتاهما تحتاج إلى الطريقة نفسها. انظر أيّ الأسطر تحرّك أيّ دائرة.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there. Look at whose radius stands in the questions.</source>
        <translation>نصف قطر الدائرة ⁨%3⁩ هو ⁦%1 m⁩، ويأتي الارتداد حين يكون المركز على بعد ⁦%2 m⁩ من الجدار: وهو نصف قطر الدائرة الأخرى هناك. انظر نصف قطر أيّ دائرة يرد في الأسئلة.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there, which is larger. Each circle has its own.</source>
        <translation>نصف قطر الدائرة ⁨%3⁩ هو ⁦%1 m⁩، وهي ترتدّ حين يكون مركزها على بعد ⁦%2 m⁩ من الجدار: وهو نصف قطر الدائرة الأخرى هناك، وهو أكبر. لكل دائرة نصف قطرها.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there, which is smaller. Each circle has its own.</source>
        <translation>نصف قطر الدائرة ⁨%3⁩ هو ⁦%1 m⁩، وهي ترتدّ حين يكون مركزها على بعد ⁦%2 m⁩ من الجدار: وهو نصف قطر الدائرة الأخرى هناك، وهو أصغر. لكل دائرة نصف قطرها.</translation>
    </message>
    <message>
        <source>Here the radius of circle %3 is %1 m, and yet it turns when its centre is 0.2 m from the wall. Take the radius that the circle has.</source>
        <translation>نصف قطر الدائرة ⁨%3⁩ هنا ⁦%1 m⁩، ومع ذلك يأتي الارتداد حين يكون المركز على بعد ⁦0.2 m⁩ من الجدار. خذ نصف القطر الذي للدائرة.</translation>
    </message>
    <message>
        <source>Circle %1 was turned round again while it left a wall

It was on its way back from the %2 and was turned into it once more. Put it back inside, or ask which way it moves before you turn it.</source>
        <translation>رُدّت الدائرة ⁨%1⁩ مرة أخرى وهي تغادر جدارًا

كانت عائدة من ⁨%2⁩ فرُدّت إليه مرة أخرى. أعدها إلى الداخل، أو اسأل إلى أين تتحرك قبل أن تردّها.</translation>
    </message>
    <message>
        <source>Circle %1 was turned round again while it left a wall

It was on its way back from the %2 and was turned into it once more; in a run that begins there it goes on. Look at what your program keeps from one step to the next.</source>
        <translation>رُدّت الدائرة ⁨%1⁩ مرة أخرى وهي تغادر جدارًا

كانت عائدة من ⁨%2⁩ فرُدّت إليه مرة أخرى؛ وفي تشغيل يبدأ من هناك تواصل. انظر إلى ما يحفظه برنامجك من خطوة إلى التي تليها.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m; v Δt is %4 m.</source>
        <translation>بسرعة ⁦%1 m/s⁩ و⁦Δt = %2 s⁩ تكون المسافة في الخطوة ⁦%3 m⁩؛ و⁦v&#xa0;Δt⁩ هو ⁦%4 m⁩.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m, with %4 m/s %5 m; v Δt is %6 and %7 m.</source>
        <translation>بسرعة ⁦%1 m/s⁩ و⁦Δt = %2 s⁩ تكون المسافة في الخطوة ⁦%3 m⁩، وبسرعة ⁦%4 m/s⁩ تكون ⁦%5 m⁩؛ و⁦v&#xa0;Δt⁩ هو ⁨%6⁩ و⁦%7 m⁩.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m, with %4 m/s %5 m; %6 and %7 m are right.</source>
        <translation>بسرعة ⁦%1 m/s⁩ و⁦Δt = %2 s⁩ تكون المسافة في الخطوة ⁦%3 m⁩، وبسرعة ⁦%4 m/s⁩ تكون ⁦%5 m⁩؛ والصحيح ⁨%6⁩ و⁦%7 m⁩.</translation>
    </message>
    <message>
        <source>The way of a step is %1 with the velocity %2 m/s, and %3 with %4 m/s. Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods ½ g Δt². Look at what is asked before the lines that change the position.</source>
        <translation>مسافة الخطوة ⁦%1⁩ بسرعة ⁦%2 m/s⁩، و⁦%3⁩ بسرعة ⁦%4 m/s⁩. أويلر لا تضيف شيئًا إلى ⁦v Δt⁩، وأويلر التماثلية تضيف ⁦g Δt²⁩، والطرائق الدقيقة ⁦½ g Δt²⁩. انظر ما الذي يُسأل قبل الأسطر التي تغيّر الموضع.</translation>
    </message>
    <message>
        <source>Every step must add v Δt to the position. Look at what the line that changes the position takes in its place.</source>
        <translation>يجب أن تضيف كل خطوة ⁦v Δt⁩ إلى الموضع. انظر ماذا يأخذ السطر الذي يغيّر الموضع بدلًا منه.</translation>
    </message>
    <message>
        <source>Every step must add v Δt to the position.</source>
        <translation>يجب أن تضيف كل خطوة ⁦v Δt⁩ إلى الموضع.</translation>
    </message>
    <message>
        <source>Started with %1 m/s under gravity %2 m/s², away from every wall and every other circle, its velocity is 0 one step later; without gravity it keeps it.</source>
        <translation>بدأت بسرعة ⁦%1 m/s⁩ تحت الجاذبية ⁦%2 m/s²⁩ بعيدًا عن كل جدار وكل دائرة أخرى، فصارت سرعتها 0 بعد خطوة واحدة؛ ومن دون جاذبية تحتفظ بها.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, away from every wall and every other circle, its velocity is 0 one step later.</source>
        <translation>بدأت بسرعة ⁦%1 m/s⁩ بعيدًا عن كل جدار وكل دائرة أخرى، فصارت سرعتها 0 بعد خطوة واحدة.</translation>
    </message>
    <message>
        <source>Under gravity a step took the velocity of %who away</source>
        <translation>تحت الجاذبية أزالت خطوة سرعة %who</translation>
    </message>
    <message>
        <source>Look at the lines that stop a circle, and at what is asked before they run: is it true although nothing touches?</source>
        <translation>انظر إلى الأسطر التي توقف دائرة وإلى ما يُسأل قبلها: هل يتحقق مع أن لا شيء يتلامس؟</translation>
    </message>
    <message>
        <source>In free flight gravity leaves %who alone</source>
        <translation>في الطيران الحر لا تؤثر الجاذبية في %who</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep of %who</source>
        <translation>يحلّ عدد ثابت محلّ الخطوة الزمنية، في %who</translation>
    </message>
    <message>
        <source>At every timestep tried the whole step is made as if Δt were %1 s. Take the parameter of `on_update`.</source>
        <translation>مع كل خطوة زمنية مجرّبة تُنفَّذ الخطوة كلها كأن ⁦Δt = %1 s⁩. خذ معامل `on_update`.</translation>
    </message>
    <message>
        <source>In free flight a step leaves %who as it was</source>
        <translation>في الطيران الحر لا تغيّر الخطوة شيئًا في %who</translation>
    </message>
    <message>
        <source>Far from the %1 something turns %who round</source>
        <translation>شيء ما يردّ %who بعيدًا عن %1</translation>
    </message>
    <message>
        <source>A start towards the %1 turns %who round</source>
        <translation>بداية نحو %1 تردّ %who</translation>
    </message>
    <message>
        <source>Thrown straight towards the %1 with %2 m/s from %3 m, circle %4 has %5 m/s one step of %6 s later.</source>
        <translation>عند رمي الدائرة ⁨%4⁩ مباشرة نحو %1 بسرعة ⁦%2 m/s⁩ من ⁦%3 m⁩ تصبح سرعتها ⁦%5 m/s⁩ بعد خطوة واحدة مدتها ⁦%6 s⁩.</translation>
    </message>
    <message>
        <source>It is at %1 m then.</source>
        <translation>وتكون حينئذ عند ⁦%1 m⁩.</translation>
    </message>
    <message>
        <source>So it is from all places tried; thrown the other way it goes on as it should.</source>
        <translation>وكذلك الأمر من كل المواضع المجرَّبة؛ وعند رميها في الاتجاه المعاكس تواصل كما ينبغي.</translation>
    </message>
    <message>
        <source>So it is where its centre comes to %1 or farther, and its rim to %2; the wall is at %3.</source>
        <translation>وكذلك الأمر حيث يبلغ مركزها ⁦%1⁩ أو ما بعده وحافتها ⁦%2⁩؛ والجدار عند ⁦%3⁩.</translation>
    </message>
    <message>
        <source>Look at what your program asks for that wall, at the lengths there and at their signs.</source>
        <translation>انظر إلى ما يسأله برنامجك عن ذلك الجدار، وإلى الأطوال هناك وإشاراتها.</translation>
    </message>
    <message>
        <source>Turned towards it by the wall opposite, it goes on. Look at what your program takes over of the velocity that a run begins with.</source>
        <translation>وحين يردّها الجدار المقابل نحوه تواصل. انظر إلى ما يأخذه برنامجك من السرعة التي يبدأ بها التشغيل.</translation>
    </message>
    <message>
        <source>The position does not change, either. Look at whether the lines that move a circle are reached in every step, and for which circle.</source>
        <translation>والموضع أيضًا لا يتغيّر. انظر هل يُبلَغ في كل خطوة إلى الأسطر التي تحرّك دائرة، ولأيّ دائرة.</translation>
    </message>
    <message>
        <source>The whole step of %who is made as with %1 Δt</source>
        <translation>تُنفَّذ الخطوة كلها كما مع ⁦%1 Δt⁩، في %who</translation>
    </message>
    <message>
        <source>The way is %1 times v Δt, too: look at which Δt the lines of a step take, and at how often they run.</source>
        <translation>والمسافة أيضًا ⁨%1⁩ أضعاف ⁦v Δt⁩: انظر أيّ ⁦Δt⁩ تأخذه أسطر الخطوة، وكم مرة تُنفَّذ.</translation>
    </message>
    <message>
        <source>Circle %1 moved only in a step in which a wall was hit</source>
        <translation>لم تتحرك الدائرة ⁨%1⁩ إلا في خطوة فيها تصادم بجدار</translation>
    </message>
    <message>
        <source>In the step in which circle %1 was answered by the %2 the other circle went %3 m; in no step before did it move. Look at what lets a step end before its turn, as `return` and `break` do, and at what is asked before it moves.</source>
        <translation>في الخطوة التي استجيب فيها للدائرة ⁨%1⁩ (⁨%2⁩) تقدمت الدائرة الأخرى ⁦%3 m⁩؛ ولم تتحرك في أي خطوة قبلها. انظر ما الذي ينهي الخطوة قبل دورها، كما يفعل `return` و`break`، وما الذي يُسأل قبل أن تتحرك.</translation>
    </message>
    <message>
        <source>In free flight a step moves %who nowhere</source>
        <translation>في الطيران الحر لا تنقل الخطوة %who</translation>
    </message>
    <message>
        <source>The circles are answered far apart, not where they touch</source>
        <translation>تستجيب الدائرتان وهما بعيدتان، لا حيث تتلامسان</translation>
    </message>
    <message>
        <source>At %1 and %2 m, opposite each other about the middle of the square, they were answered with their centres %3 m apart.</source>
        <translation>عند ⁨%1⁩ و⁦%2 m⁩، متقابلتين حول منتصف المربع، استجابتا والمسافة بين المركزين ⁦%3 m⁩.</translation>
    </message>
    <message>
        <source>Look at whether the two places are subtracted: their sum is not the way from one to the other.</source>
        <translation>انظر هل يُطرح أحد الموضعين من الآخر: فمجموعهما ليس الطريق من أحدهما إلى الآخر.</translation>
    </message>
    <message>
        <source>From all %1 directions in which they were thrown at each other, with up to %2 m/s along the line of centres, neither of them changed its velocity.</source>
        <translation>في الاتجاهات كلها، وعددها ⁨%1⁩، التي قُذفت فيها كل منهما نحو الأخرى بسرعة لا تزيد على ⁦%2 m/s⁩ على خط المركزين لم تغيّر أي منهما سرعتها.</translation>
    </message>
    <message>
        <source>In your own scene, with %1 m/s, they were answered in time: look at what your program asks before they answer.</source>
        <translation>أما في مشهدك، بسرعة ⁦%1 m/s⁩، فاستجابتا في الوقت المناسب: انظر عمّ يسأل برنامجك قبل أن تستجيبا.</translation>
    </message>
    <message>
        <source>In your own scene their velocities changed where their centres were between %1 and %2 m apart; rims touch there at %3 m. Look at what their distance is compared with, and at what is asked besides.</source>
        <translation>أما في مشهدك فتغيّرت السرعتان حين كانت المسافة بين المركزين بين ⁨%1⁩ و⁦%2 m⁩؛ وتتلامس الحافتان هناك عند ⁦%3 m⁩. انظر بماذا تُقارَن المسافة، وما الذي يُسأل غير ذلك.</translation>
    </message>
    <message>
        <source>Gravity leaves %who at rest</source>
        <translation>تترك الجاذبية %who في السكون</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7) the masses, whichever stands where, are as 1 to %5; 1 to %6 is right.</source>
        <translation>مع ⁦r₁ = %1⁩ و⁦r₂ = %2 m⁩، و⁦ρ₁ = %3⁩ و⁦ρ₂ = %4⁩ (و⁦e = %7⁩)، نسبة الكتلتين، أيًّا كان موضع كل منهما، ⁦1 : %5⁩؛ الصواب ⁦1 : %6⁩.</translation>
    </message>
    <message>
        <source>Circle %1 answers as if it had the mass of the other</source>
        <translation>تستجيب الدائرة ⁨%1⁩ كأن لها كتلة الأخرى</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the mass of the other</source>
        <translation>تستجيب كل دائرة كأن لها كتلة الأخرى</translation>
    </message>
    <message>
        <source>The heavier one is pushed away faster. Look at what each mass is made of, and at which stands where.</source>
        <translation>الأثقل تُدفع أسرع. انظر ممّ تُحسب كل كتلة، وأيّها ترد أين.</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the other&apos;s radius</source>
        <translation>تستجيب كل دائرة كأن لها نصف قطر الأخرى</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the other&apos;s density</source>
        <translation>تستجيب كل دائرة كأن لها كثافة الأخرى</translation>
    </message>
    <message>
        <source>Look at whose radius stands in which mass, and on which side of a division.</source>
        <translation>انظر نصف قطر أيّ دائرة يرد في أيّ كتلة، وعلى أيّ جانب من القسمة.</translation>
    </message>
    <message>
        <source>Look at whose density stands in which mass, and on which side of a division.</source>
        <translation>انظر كثافة أيّ دائرة ترد في أيّ كتلة، وعلى أيّ جانب من القسمة.</translation>
    </message>
    <message>
        <source>In the rebound the two shares are exchanged</source>
        <translation>في الارتداد تبادلت الحصّتان</translation>
    </message>
    <message>
        <source>What comes back of the speed is e times it, not √e times.</source>
        <translation>يعود من السرعة ⁦e⁩ مرة، لا ⁦√e⁩ مرة.</translation>
    </message>
    <message>
        <source>As one circle hit a wall the way of the other changed</source>
        <translation>حين اصطدمت دائرة بجدار تغيّر طريق الأخرى</translation>
    </message>
    <message>
        <source>They answer %2 m apart: that squared is about r₁ + r₂. A square is in m², a length in m.</source>
        <translation>تستجيبان والمسافة ⁦%2 m⁩: ومربعها نحو ⁦r₁ + r₂⁩. المربع بوحدة ⁦m²⁩ والطول بوحدة ⁦m⁩.</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m they answered when their centres were between %3 and %4 m apart; rims touch where that is %5 m.</source>
        <translation>مع ⁦r₁ = %1 m⁩ و⁦r₂ = %2 m⁩ استجابتا حين كانت المسافة بين المركزين بين ⁨%3⁩ و⁦%4 m⁩؛ وتتلامس الحافتان عند ⁦%5 m⁩.</translation>
    </message>
    <message>
        <source>Thrown with up to %1 m/s along the line of centres they answer in time.</source>
        <translation>وإذا قُذفتا بسرعة لا تزيد على ⁦%1 m/s⁩ على خط المركزين استجابتا في الوقت الصحيح.</translation>
    </message>
    <message>
        <source>In scenes that have their radii before your program begins they answer in time.</source>
        <translation>في المشاهد التي تكون أنصاف الأقطار فيها معطاة قبل أن يبدأ برنامجك تستجيبان في الوقت الصحيح.</translation>
    </message>
    <message>
        <source>Look at when your program reads the radii: what is read before `on_load` sets them is an old value.</source>
        <translation>انظر متى يقرأ برنامجك نصفي القطرين: ما يُقرأ قبل أن يضبطهما `on_load` قيمة قديمة.</translation>
    </message>
    <message>
        <source>Look at what the distance is compared with, and at what is asked besides.</source>
        <translation>انظر بماذا تُقارَن المسافة، وما الذي يُسأل غير ذلك.</translation>
    </message>
    <message>
        <source>A hit puts the circles into each other</source>
        <translation>يضع التصادم الدائرتين إحداهما داخل الأخرى</translation>
    </message>
    <message>
        <source>They came until their centres were %1 m apart, and the step with the answer put them %2 m apart; rims touch at %3 m. Look at the place that each of the two gets.</source>
        <translation>جاءتا حتى صارت المسافة بين المركزين ⁦%1 m⁩، ووضعتهما خطوة الاستجابة على مسافة ⁦%2 m⁩؛ وتتلامس الحافتان عند ⁦%3 m⁩. انظر الموضع الذي تناله كل منهما.</translation>
    </message>
    <message>
        <source>The push is multiplied by the distance of the centres, in m. A direction has length 1: divide the way from one to the other by its length wherever it stands.</source>
        <translation>يُضرب الدفع في المسافة بين المركزين بوحدة ⁦m⁩. الاتجاه طوله 1: اقسم الطريق من إحداهما إلى الأخرى على طوله حيثما ورد.</translation>
    </message>
    <message>
        <source>The rebound depends on how deep the circles overlap</source>
        <translation>يتوقف الارتداد على مقدار تداخل الدائرتين</translation>
    </message>
    <message>
        <source>With a timestep of %1 s the circles parted with %2 times the speed along the push that they met with; %3 is right.</source>
        <translation>بخطوة زمنية ⁦%1 s⁩ افترقت الدائرتان بسرعة على اتجاه الدفع تساوي ⁨%2⁩ مرة السرعة التي التقتا بها؛ الصواب ⁨%3⁩.</translation>
    </message>
    <message>
        <source>In very short steps it comes out right: look at whether the normal has length 1 where they overlap.</source>
        <translation>وفي خطوات قصيرة جدًّا يصح ذلك: انظر هل طول الناظم 1 حيث تتداخلان.</translation>
    </message>
    <message>
        <source>With e = %1 and a timestep of %2 s the circles parted with %3 times the speed along the push that they met with; %4 is right.</source>
        <translation>مع ⁦e = %1⁩ وبخطوة زمنية ⁦%2 s⁩ افترقت الدائرتان بسرعة على اتجاه الدفع تساوي ⁨%3⁩ مرة السرعة التي التقتا بها؛ الصواب ⁨%4⁩.</translation>
    </message>
    <message>
        <source>e multiplies the whole new part of circle %1</source>
        <translation>تُضرب مركّبة الدائرة ⁨%1⁩ الجديدة كاملةً في e</translation>
    </message>
    <message>
        <source>e multiplies both whole new parts</source>
        <translation>تُضرب المركّبتان الجديدتان كاملتين في e</translation>
    </message>
    <message>
        <source>The push is divided by the distance of the centres</source>
        <translation>يُقسم الدفع على المسافة بين المركزين</translation>
    </message>
    <message>
        <source>The push is divided by the square of the distance of the centres, in m. A direction has length 1: look at how often the way from one to the other is divided by its length.</source>
        <translation>يُقسم الدفع على مربع المسافة بين المركزين بوحدة ⁦m⁩. الاتجاه طوله 1: انظر كم مرة يُقسم الطريق من إحداهما إلى الأخرى على طوله.</translation>
    </message>
    <message>
        <source>The distance, in m, must not change the size of the push. Look at how often the way from one to the other is divided by its length.</source>
        <translation>لا يجوز أن تغيّر المسافة، بوحدة ⁦m⁩، مقدار الدفع. انظر كم مرة يُقسم الطريق من إحداهما إلى الأخرى على طوله.</translation>
    </message>
    <message>
        <source>The push acts along the velocity of circle 2</source>
        <translation>يؤثر الدفع على امتداد سرعة الدائرة 2</translation>
    </message>
    <message>
        <source>Each circle gets the new part of the other</source>
        <translation>تحصل كل دائرة على المركّبة الجديدة للأخرى</translation>
    </message>
    <message>
        <source>In all hits tried both new parts along the line of centres are as they should be, but circle 1 has that of circle 2, and circle 2 that of circle 1. Look at which result goes to which circle.</source>
        <translation>في كل التصادمات التي جُرّبت تكون المركّبتان الجديدتان على خط المركزين كما ينبغي، لكن للدائرة 1 مركّبة الدائرة 2 وللدائرة 2 مركّبة الدائرة 1. انظر أي نتيجة تذهب إلى أي دائرة.</translation>
    </message>
    <message>
        <source>What the two have in common does not depend on the masses</source>
        <translation>ما تشترك فيه الدائرتان لا يتوقف على الكتلتين</translation>
    </message>
    <message>
        <source>In all hits tried what parts them again comes out right, but what both have in common is the mean of the two velocities along that line, whatever the masses are. The total momentum is not kept then, so no masses make it right. Look at where that mean is worked out.</source>
        <translation>في كل التصادمات التي جُرّبت يخرج ما يفرّقهما من جديد صحيحًا، لكن ما تشتركان فيه هو متوسط السرعتين على ذلك الخط أيًا كانت الكتلتان. عندئذ لا تُحفظ كمية الحركة الكلية، فلا تصح بأي كتل. انظر إلى حيث يُحسب هذا المتوسط.</translation>
    </message>
    <message>
        <source>The rebound is shared half and half, whatever the masses are</source>
        <translation>يُقسم الارتداد نصفين أيًا كانت الكتلتان</translation>
    </message>
    <message>
        <source>In all hits tried what both have in common comes out right, but of what parts them again each gets one half. The total momentum is not kept then, so no masses make it right: the lighter one should get more.</source>
        <translation>في كل التصادمات التي جُرّبت يخرج ما تشتركان فيه صحيحًا، لكن مما يفرّقهما من جديد تنال كل واحدة النصف. عندئذ لا تُحفظ كمية الحركة الكلية، فلا تصح بأي كتل: ينبغي أن تنال الأخف أكثر.</translation>
    </message>
    <message>
        <source>Each circle leaves with e times the momentum of the other</source>
        <translation>تغادر كل دائرة بمقدار e من كمية حركة الأخرى</translation>
    </message>
    <message>
        <source>In all hits tried each circle has after the hit e times the momentum along that line that the other came with. The total momentum is not kept then: e acts on how fast they part alone.</source>
        <translation>في كل التصادمات التي جُرّبت يكون لكل دائرة بعد التصادم e في كمية الحركة على ذلك الخط التي جاءت بها الأخرى. عندئذ لا تُحفظ كمية الحركة الكلية: لا يؤثر e إلا في سرعة افتراقهما.</translation>
    </message>
    <message>
        <source>The momenta along the line of centres change hands</source>
        <translation>تتبادل الدائرتان كميتَي الحركة على خط المركزين</translation>
    </message>
    <message>
        <source>In all hits tried each circle has after the hit the momentum along that line that the other came with. That keeps the total momentum, but where the masses differ they do not part as fast as they met.</source>
        <translation>في كل التصادمات التي جُرّبت يكون لكل دائرة بعد التصادم كمية الحركة على ذلك الخط التي جاءت بها الأخرى. هذا يحفظ كمية الحركة الكلية، لكن حيث تختلف الكتلتان لا تفترقان بالسرعة التي التقتا بها.</translation>
    </message>
    <message>
        <source>The new parts along the line of centres have a wrong size</source>
        <translation>مقدار المركّبتين الجديدتين على خط المركزين خاطئ</translation>
    </message>
    <message>
        <source>Both pushes have a wrong size</source>
        <translation>مقدار الدفعين خاطئ</translation>
    </message>
    <message>
        <source>Look at where the two masses are subtracted, and where they are added.</source>
        <translation>انظر أين تُطرح الكتلتان وأين تُجمعان.</translation>
    </message>
    <message>
        <source>In all hits tried of two masses both new parts are (m₁ + m₂) / (m₁ − m₂) times what is right.</source>
        <translation>في كل التصادمات التي جُرّبت لكتلتين مختلفتين يساوي كلٌّ من المركّبتين الجديدتين الصواب مضروبًا في ⁦(m₁ + m₂) / (m₁ − m₂)⁩.</translation>
    </message>
    <message>
        <source>In all hits tried of two masses both pushes are (m₁ + m₂) / (m₁ − m₂) times what is right.</source>
        <translation>في كل التصادمات التي جُرّبت لكتلتين مختلفتين يساوي كلٌّ من الدفعين الصواب مضروبًا في ⁦(m₁ + m₂) / (m₁ − m₂)⁩.</translation>
    </message>
    <message>
        <source>In all %1 meetings tried circle 2 was at rest; in your own scene it came with %2 m/s, and there they were answered in time. Look at whose velocities the answer is made of, and at what is asked before it.</source>
        <translation>في اللقاءات التي جُرّبت كلها، وعددها ⁨%1⁩، كانت الدائرة 2 ساكنة؛ أما في مشهدك فجاءت بسرعة ⁦%2 m/s⁩، وهناك استجابتا في الوقت المناسب. انظر من سرعات أيّ دائرة تتكوّن الاستجابة، وعمّ يُسأل قبلها.</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s, touched and kept their velocities; with %2 m/s they are answered.</source>
        <translation>اقتربتا بسرعة ⁦%1 m/s⁩ وتلامستا واحتفظتا بسرعتيهما؛ وعند ⁦%2 m/s⁩ تستجيبان.</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s and ran into each other; with %2 m/s they are answered.</source>
        <translation>اقتربتا بسرعة ⁦%1 m/s⁩ وتداخلتا؛ وعند ⁦%2 m/s⁩ تستجيبان.</translation>
    </message>
    <message>
        <source>How fast they come does not matter: what counts is whether they overlap and come nearer.</source>
        <translation>لا يهم مقدار سرعتهما: المهم هل تتداخلان وتتقاربان.</translation>
    </message>
    <message>
        <source>%1 (with e = %2)</source>
        <translation>⁨%1⁩ (مع ⁦e = %2⁩)</translation>
    </message>
    <message>
        <source>They go on side by side and do not part: each gets only half of the change that an elastic hit makes. Look for a factor 2 that is missing, or for a half or a mean.</source>
        <translation>تمضيان جنبًا إلى جنب ولا تفترقان: لا تنال كل منهما إلا نصف التغيّر الذي يحدثه تصادم مرن. ابحث عن عامل 2 ناقص، أو عن نصف أو متوسط.</translation>
    </message>
    <message>
        <source>In your own scene the walls do not use the e that it has</source>
        <translation>في مشهدك لا تستعمل الجدران e الذي له</translation>
    </message>
    <message>
        <source>Each circle goes on with the velocity of the other</source>
        <translation>تواصل كل دائرة سيرها بسرعة الأخرى</translation>
    </message>
    <message>
        <source>However they are started, what each has one step later comes from the velocity of the other: started with %1 m/s, circle %2 has %3 m/s. Each goes on from its own velocity: look at the names in the lines that change it, and at what is asked before them.</source>
        <translation>كيفما كانت البداية تأتي سرعة كلٍّ منهما بعد خطوة واحدة من سرعة الأخرى: بدأت الدائرة ⁨%2⁩ بسرعة ⁦%1 m/s⁩ فصارت ⁦%3 m/s⁩. كل دائرة تنطلق من سرعتها هي: انظر إلى الأسماء في الأسطر التي تغيّرها، وإلى ما يُسأل عنه قبلها.</translation>
    </message>
    <message>
        <source>In free flight a step took the velocity of %who away</source>
        <translation>في الطيران الحر أزالت خطوة سرعة %who</translation>
    </message>
    <message>
        <source>What a hit makes is worked out from the velocities before it.</source>
        <translation>ما ينتج عن التصادم يُحسب من السرعات التي قبله.</translation>
    </message>
    <message>
        <source>The velocities after a hit do not depend on those before</source>
        <translation>السرعتان بعد التصادم لا تتعلقان بالسرعتين قبله</translation>
    </message>
    <message>
        <source>From all hits tried circle 1 leaves with %1 m/s and circle 2 with %2 m/s.</source>
        <translation>من كل التصادمات المجرّبة تغادر الدائرة 1 بسرعة ⁦%1 m/s⁩ والدائرة 2 بسرعة ⁦%2 m/s⁩.</translation>
    </message>
    <message>
        <source>The new parts along the normal do not depend on the old ones</source>
        <translation>المركّبتان الجديدتان على الناظم لا تتعلقان بالقديمتين</translation>
    </message>
    <message>
        <source>Along the line of centres, from 1 to 2, circle 1 leaves all hits tried with %1 m/s and circle 2 with %2 m/s.</source>
        <translation>على خط المركزين، من 1 إلى 2، تغادر الدائرة 1 كل التصادمات المجرّبة بسرعة ⁦%1 m/s⁩ والدائرة 2 بسرعة ⁦%2 m/s⁩.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early: %2.</source>
        <translation>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، لم تأتِ الاستجابة، في وقتها أو مبكرة، في أي لقاء: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في لقاء واحد: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في لقاءين: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في %n: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في %n: %2.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في %n: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early.</source>
        <translation>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، لم تأتِ الاستجابة، في وقتها أو مبكرة، في أي لقاء.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في لقاء واحد.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في لقاءين.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في %n.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في %n.</numerusform>
            <numerusform>من اللقاءات المجرّبة، وعددها ⁨%1⁩، جاءت الاستجابة، في وقتها أو مبكرة، في %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>A hit changes velocities: look at whether the lines for that run, at what is asked before them, and at whether later lines change the velocities back.</source>
        <translation>التصادم يغيّر السرعات: انظر هل تُنفَّذ الأسطر التي تفعل ذلك، وعمّ يُسأل قبلها، وهل تعيد أسطر لاحقة السرعات كما كانت.</translation>
    </message>
    <message>
        <source>When they touched neither moved on as its velocity says, and after the step they had the velocities of before.</source>
        <translation>عند تلامسهما لم تتقدم أي منهما كما تقول سرعتها، وبعد الخطوة كانت لهما السرعتان السابقتان.</translation>
    </message>
    <message>
        <source>When they touched circle %1 did not move on as its velocity says, and after the step both had the velocities of before.</source>
        <translation>عند تلامسهما لم تتقدم الدائرة ⁨%1⁩ كما تقول سرعتها، وبعد الخطوة كانت لكلتيهما السرعتان السابقتان.</translation>
    </message>
    <message>
        <source>In the first hit of a run the line of centres was at %1°, in a later one at %2°. Both times the push was along the first line. Every hit has a normal of its own: work it out anew.</source>
        <translation>في أول تصادم من تشغيل كان خط المركزين عند ⁦%1°⁩، وفي تصادم لاحق عند ⁦%2°⁩. وفي المرتين كان الدفع على الخط الأول. لكل تصادم ناظم خاص به: احسبه من جديد.</translation>
    </message>
    <message>
        <source>The larger of two circles answers as the lighter one</source>
        <translation>تستجيب الكبرى من الدائرتين كأنها الأخف</translation>
    </message>
    <message>
        <source>Of the same density it is the heavier one. Look at whose radius stands in which mass, and at which mass stands where.</source>
        <translation>وهي عند تساوي الكثافة الأثقل. انظر نصف قطر أيّ دائرة يرد في أيّ كتلة، وأيّ كتلة ترد أين.</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with ρ₁ = %2 and ρ₂ = %3 as if it were %4 times. Compare the lines for the two masses.</source>
        <translation>دائرتان متساويتان في نصف القطر والكثافة تستجيبان كأن كتلة الدائرة 2 تساوي كتلة الدائرة 1 مضروبةً في ⁨%1⁩، ومع ⁦ρ₁ = %2⁩ و⁦ρ₂ = %3⁩ مضروبةً في ⁨%4⁩. قارن بين سطري الكتلتين.</translation>
    </message>
    <message>
        <source>The two masses have the same ratio in all hits tried</source>
        <translation>للكتلتين النسبة نفسها في كل التصادمات المجرّبة</translation>
    </message>
    <message>
        <source>Of whatever size and density the two are, they answer as if circle 2 were %1 times as heavy as circle 1. Work each mass out from the `radius` and `density` of its own circle, which other scenes change.</source>
        <translation>مهما كان حجم الدائرتين وكثافتهما فإنهما تستجيبان كأن كتلة الدائرة 2 تساوي كتلة الدائرة 1 مضروبةً في ⁨%1⁩. احسب كل كتلة من ⁦`radius`⁩ و⁦`density`⁩ لدائرتها هي، اللذين تغيّرهما مشاهد أخرى.</translation>
    </message>
    <message>
        <source>In your own scene even the first comes out wrong.</source>
        <translation>وفي مشهدك لا تصحّ حتى نتيجة الأول.</translation>
    </message>
    <message>
        <source>In your own scene, where circle 2 rests, the first hit comes out right.</source>
        <translation>في مشهدك، حيث الدائرة 2 ساكنة، تصحّ نتيجة التصادم الأول.</translation>
    </message>
    <message>
        <source>Equal circles get %1 times the right push</source>
        <translation>تتلقى دائرتان متساويتان الدفع الصحيح مضروبًا في ⁨%1⁩</translation>
    </message>
    <message>
        <source>The push is multiplied by %1 + %2 e instead of 1 + e</source>
        <translation>الدفع مضروب في ⁦%1 + %2 e⁩ بدلًا من ⁦1 + e⁩</translation>
    </message>
    <message>
        <source>The push is multiplied by %1 − %2 e instead of 1 + e</source>
        <translation>الدفع مضروب في ⁦%1 − %2 e⁩ بدلًا من ⁦1 + e⁩</translation>
    </message>
    <message>
        <source>Both parts of a velocity have to become 0.</source>
        <translation>يجب أن تصير مركّبتا السرعة كلتاهما 0.</translation>
    </message>
    <message>
        <source>A hit stops circle 1 and not circle 2</source>
        <translation>يوقف التصادم الدائرة 1 ولا يوقف الدائرة 2</translation>
    </message>
    <message>
        <source>A hit stops circle 2 and not circle 1</source>
        <translation>يوقف التصادم الدائرة 2 ولا يوقف الدائرة 1</translation>
    </message>
    <message>
        <source>A hit has to stop both.</source>
        <translation>يجب أن يوقف التصادم كلتيهما.</translation>
    </message>
    <message>
        <source>Circle 1 came with %1 m/s and left with %2 m/s, circle 2 came with %3 m/s and left with %4 m/s.</source>
        <translation>جاءت الدائرة 1 بسرعة ⁦%1 m/s⁩ وغادرت بسرعة ⁦%2 m/s⁩، وجاءت الدائرة 2 بسرعة ⁦%3 m/s⁩ وغادرت بسرعة ⁦%4 m/s⁩.</translation>
    </message>
    <message>
        <source>The circles exchange their whole velocities</source>
        <translation>تتبادل الدائرتان سرعتيهما كاملتين</translation>
    </message>
    <message>
        <source>Circle 1 loses its part across the normal</source>
        <translation>تفقد الدائرة 1 مركّبتها المعامدة للناظم</translation>
    </message>
    <message>
        <source>Circle 2 loses its part across the normal</source>
        <translation>تفقد الدائرة 2 مركّبتها المعامدة للناظم</translation>
    </message>
    <message>
        <source>Circle %3 is turned only when its centre is past the wall, with its rim one radius, %1 m, outside. A wall meets a body where the body ends.</source>
        <translation>لا ترتدّ الدائرة ⁨%3⁩ إلا حين يتجاوز مركزها الجدار، والحافة خارجه بنصف قطر، ⁦%1 m⁩. الجدار يلاقي الجسم حيث ينتهي الجسم.</translation>
    </message>
    <message>
        <source>The acceleration is %1 m/s², under gravity %2 and under %3 m/s² alike.</source>
        <translation>التسارع ⁦%1 m/s²⁩، تحت الجاذبية ⁦%2⁩ وتحت ⁦%3 m/s²⁩ على السواء.</translation>
    </message>
    <message>
        <source>The fall of %who depends on radius or density</source>
        <translation>سقوط %who يتوقف على نصف القطر أو الكثافة</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² circle %4 is accelerated by %2 m/s², and by %3 m/s² when its radius is 1.25 times and its density 1.5 times as large. Gravity is an acceleration already: all bodies fall alike, whatever they weigh.</source>
        <translation>تحت الجاذبية ⁦%1 m/s²⁩ يكون تسارع الدائرة ⁨%4⁩ ⁦%2 m/s²⁩، ويصير ⁦%3 m/s²⁩ حين يُضرب نصف القطر في 1.25 والكثافة في 1.5. الجاذبية تسارع أصلًا: كل الأجسام تسقط سقوطًا واحدًا، مهما كان ثقلها.</translation>
    </message>
    <message>
        <source>So it is from every start tried.</source>
        <translation>هكذا هو من كل بداية جُرّبت.</translation>
    </message>
    <message>
        <source>It has that x from every start tried.</source>
        <translation>للدائرة قيمة x هذه من كل بداية جُرّبت.</translation>
    </message>
    <message>
        <source>It has that y from every start tried.</source>
        <translation>للدائرة قيمة y هذه من كل بداية جُرّبت.</translation>
    </message>
    <message>
        <source>Thrown at each of them without gravity, %who went on through it; at the %1 with %2 m/s. Look at whether your program asks about walls for %who, and whether the answer is ever yes.</source>
        <translation>قُذفت بلا جاذبية نحو كل جدار فنفذت منه %who؛ عند ⁨%1⁩ بسرعة ⁦%2 m/s⁩. انظر هل يسأل برنامجك عن الجدران لأجل %who وهل يكون الجواب نعم أبدًا.</translation>
    </message>
    <message>
        <source>Circle %1 turned when its centre was between %2 and %3 m from the wall, with the radius %4 m as with %5 m. Take the radius that the circle has.</source>
        <translation>ارتدّت الدائرة ⁨%1⁩ حين كان مركزها على بعد بين ⁦%2⁩ و⁦%3 m⁩ من الجدار، بنصف القطر ⁦%4 m⁩ كما بنصف القطر ⁦%5 m⁩. خذ نصف القطر الذي للدائرة.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who another share of the speed than e</source>
        <translation>التصادمات عند %walls تعيد إلى %who نصيبًا من السرعة غير e</translation>
    </message>
    <message>
        <source>At the floor, none slower than %1 m/s was tried.</source>
        <translation>عند الأرضية لم يُجرَّب ما هو أبطأ من ⁦%1 m/s⁩.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m</source>
        <translation>بسرعة ⁦%1 m/s⁩ و⁦Δt = %2 s⁩ تكون المسافة في الخطوة ⁦%3 m⁩</translation>
    </message>
    <message>
        <source>; %1 m is right.</source>
        <translation>؛ والصحيح ⁦%1 m⁩.</translation>
    </message>
    <message>
        <source>, of which %1 m are not of the velocity; v Δt is %2 m.</source>
        <translation>، منها ⁦%1 m⁩ ليست من السرعة؛ و⁦v&#xa0;Δt⁩ هو ⁦%2 m⁩.</translation>
    </message>
    <message>
        <source>Only in your own scene a step moves %who</source>
        <translation>لا تنقل الخطوة %who إلا في مشهدك</translation>
    </message>
    <message>
        <source>In the first step of your own scene it goes %1 m, as its velocity there makes it. So it should from every start: look at what is asked before the line that moves it.</source>
        <translation>في الخطوة الأولى من مشهدك تكون المسافة ⁦%1 m⁩ كما تقتضي السرعة هناك. هكذا يجب أن يكون من كل بداية: انظر ما يُسأل عنه قبل السطر الذي ينقل.</translation>
    </message>
    <message>
        <source>The circles are answered too late, or not at all</source>
        <translation>تستجيب الدائرتان متأخرتين أو لا تستجيبان قط</translation>
    </message>
    <message>
        <source>Circle 1 answers where it meets circle 2</source>
        <translation>تستجيب الدائرة 1 حيث تلتقي الدائرة 2</translation>
    </message>
    <message>
        <source>Circle 2 answers where it meets circle 1</source>
        <translation>تستجيب الدائرة 2 حيث تلتقي الدائرة 1</translation>
    </message>
    <message>
        <source>Along the line of centres and across it alike the velocities are multiplied by one number. Both directions need length 1, else their length comes in twice.</source>
        <translation>على خط المركزين وعموديًا عليه معًا ضُربت السرعتان في عدد واحد. يجب أن يكون طول الاتجاهين 1، وإلا دخل طولهما مرتين.</translation>
    </message>
    <message>
        <source>Normal and tangent are too short</source>
        <translation>الناظم والمماس أقصر مما يجب</translation>
    </message>
    <message>
        <source>Normal and tangent are too long</source>
        <translation>الناظم والمماس أطول مما يجب</translation>
    </message>
    <message>
        <source>Mass is density times volume, for each ball with its own radius: it grows with r³.</source>
        <translation>الكتلة هي الكثافة في الحجم، ولكل كرة نصف قطرها هي: فهي تنمو مع ⁦r³⁩.</translation>
    </message>
    <message>
        <source>Two equal circles do not count as equally heavy</source>
        <translation>لا تُعدّ دائرتان متساويتان متساويتي الكتلة</translation>
    </message>
    <message>
        <source>They answer as if circle 2 were %1 times as heavy as circle 1. Compare the lines for the two masses, and those for the two pushes, number by number.</source>
        <translation>تستجيبان كأن كتلة الدائرة 2 تساوي كتلة الدائرة 1 مضروبةً في ⁨%1⁩. قارن بين سطري الكتلتين وبين سطري الدفعين عددًا عددًا.</translation>
    </message>
    <message>
        <source>With e = %1 a hit changes no velocity</source>
        <translation>مع ⁦e = %1⁩ لا يغيّر التصادم أي سرعة</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s along the line of centres, touched, and both kept their velocities; with e = %2 it comes out right. Look at what is asked before the lines with the answer, and at what e does there.</source>
        <translation>اقتربتا بسرعة ⁦%1 m/s⁩ على خط المركزين وتلامستا واحتفظت كلتاهما بسرعتها؛ ومع ⁦e = %2⁩ تصحّ النتيجة. انظر عمّ يُسأل قبل أسطر الاستجابة، وماذا يفعل ⁦e⁩ هناك.</translation>
    </message>
    <message>
        <source>all but those where %1</source>
        <translation>كلها عدا تلك التي فيها %1</translation>
    </message>
    <message>
        <source>those where %1, no others</source>
        <translation>تلك التي فيها %1، دون غيرها</translation>
    </message>
    <message>
        <source>In one of %1 s it changes as it should. Look at which Δt the line that changes the velocity takes.</source>
        <translation>وفي خطوة مدتها ⁦%1 s⁩ تتغير كما يجب. انظر أي ⁦Δt⁩ يأخذ السطر الذي يغيّر السرعة.</translation>
    </message>
    <message>
        <source>Let go at rest, it has %1 m/s one step of %2 s later, far from every wall and every other circle; gravity gives it %3 m/s in a step. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>إذا تُركت ساكنةً كانت سرعتها ⁦%1 m/s⁩ بعد خطوة مدتها ⁦%2 s⁩، بعيدةً عن كل جدار وكل دائرة أخرى؛ والجاذبية تعطيها ⁦%3 m/s⁩ في الخطوة. انظر أي الأسطر تغيّر سرعتها هناك، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and left it with %4 m/s, which is about %5 times as much, and `restitution` is %6.</source>
        <translation>جاءت الدائرة ⁨%1⁩ إلى ⁨%2⁩ بسرعة ⁦%3 m/s⁩ وغادرته بسرعة ⁦%4 m/s⁩، أي نحو ⁦%5⁩ مرة من ذلك، و⁦`restitution`⁩ هو ⁨%6⁩.</translation>
    </message>
    <message>
        <source>Other scenes come out right. A copy of e that is made before e is set keeps the old value.</source>
        <translation>المشاهد الأخرى تخرج صحيحة. نسخةٌ من e صُنعت قبل ضبط e تحتفظ بالقيمة القديمة.</translation>
    </message>
    <message>
        <source>In your own scene walls give another share of the speed back than e</source>
        <translation>في مشهدك تعيد جدران حصةً من السرعة غير e</translation>
    </message>
    <message>
        <source>Of %1 fast hits in that run, %2 came out right. Look at what the new velocity is worked out from, and at what is asked before.</source>
        <translation>من بين ⁨%1⁩ تصادمات سريعة في ذلك التشغيل، جاء صحيحًا: ⁨%2⁩. انظر ممّ تُحسب السرعة الجديدة، وما الذي يُسأل قبلها.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n were answered.</source>
        <translation>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، لم يُردّ على أي محاولة.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على واحدة.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على اثنتين.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على %n.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على %n.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n were answered: %2.</source>
        <translation>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، لم يُردّ على أي محاولة: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على واحدة: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على اثنتين: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على %n: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على %n: %2.</numerusform>
            <numerusform>من المحاولات، وعددها ⁨%1⁩، مبكرًا ومتأخرًا، هنا وهناك، رُدّ على %n: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 hits tried there, %2 came out right. Look at what your program asks there.</source>
        <translation>من بين ⁨%1⁩ تصادمات مجرّبة هناك، جاء صحيحًا: ⁨%2⁩. انظر ما الذي يسأل عنه برنامجك هناك.</translation>
    </message>
    <message>
        <source>This one was answered: circle %1 at %2 s, at the %3 at %4 m with %5 m/s.</source>
        <translation>وهذا رُدّ عليه: الدائرة ⁨%1⁩ عند ⁦%2 s⁩، عند ⁨%3⁩ في ⁦%4 m⁩ بسرعة ⁦%5 m/s⁩.</translation>
    </message>
    <message>
        <source>Look at what your program asks besides whether the rim is past the wall and the circle moves into it.</source>
        <translation>انظر ما الذي يسأله برنامجك فوق ذلك: يكفي أن تكون الحافة وراء الجدار وأن تتحرك الدائرة نحوه.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s and e = %3, circle %4 went on past it; with %5 m/s and e = %6 it did not.</source>
        <translation>قُذفت الدائرة ⁨%4⁩ نحو ⁨%1⁩ بسرعة ⁦%2 m/s⁩ مع ⁦e = %3⁩ فمضت إلى ما بعده؛ وبسرعة ⁦%5 m/s⁩ مع ⁦e = %6⁩ لم تمضِ.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past it; with %5 m/s from %6 m it is turned round.</source>
        <translation>قُذفت الدائرة ⁨%4⁩ نحو ⁨%1⁩ بسرعة ⁦%2 m/s⁩ من ⁦%3 m⁩ فمضت إلى ما بعده؛ وبسرعة ⁦%5 m/s⁩ من ⁦%6 m⁩ تُردّ.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past it; with %5 m/s from %6 m it is held there.</source>
        <translation>قُذفت الدائرة ⁨%4⁩ نحو ⁨%1⁩ بسرعة ⁦%2 m/s⁩ من ⁦%3 m⁩ فمضت إلى ما بعده؛ وبسرعة ⁦%5 m/s⁩ من ⁦%6 m⁩ تُمسَك هناك.</translation>
    </message>
    <message>
        <source>Slow hits at the %walls turn %who round too early</source>
        <translation>التصادمات البطيئة عند %walls تردّ %who قبل الأوان</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and turned when its centre was between %4 and %5 m from the wall; its radius is %6 m. With %7 m/s it turned at its rim, as far as a step of %8 m shows.</source>
        <translation>جاءت الدائرة ⁨%1⁩ إلى ⁨%2⁩ بسرعة ⁦%3 m/s⁩ وارتدّت حين كان مركزها بين ⁨%4⁩ و⁦%5 m⁩ من الجدار؛ ونصف قطرها ⁦%6 m⁩. وبسرعة ⁦%7 m/s⁩ ارتدّت عند حافتها، بقدر ما تُظهره خطوة طولها ⁦%8 m⁩.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who one and the same speed</source>
        <translation>التصادمات عند %walls تعطي %who سرعة واحدة بعينها</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with %1 m/s: work the new velocity out from the old one.</source>
        <translation>من كل سرعة جُرّبت تغادر بسرعة ⁦%1 m/s⁩: احسب السرعة الجديدة من القديمة.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round a step too late</source>
        <translation>التصادمات عند %walls تردّ %who متأخرة خطوة</translation>
    </message>
    <message>
        <source>At the %1 the rim of circle %2 was %3 m past the wall before the step in which it was turned round, and %4 m after it. Turn it in the step in which its rim comes past the wall.</source>
        <translation>عند ⁨%1⁩ كانت حافة الدائرة ⁨%2⁩ وراء الجدار بمقدار ⁦%3 m⁩ قبل الخطوة التي رُدّت فيها، وبمقدار ⁦%4 m⁩ بعدها. رُدّها في الخطوة التي تتجاوز فيها حافتها الجدار.</translation>
    </message>
    <message>
        <source>In a corner the velocity of %who is lost</source>
        <translation>في الركن تضيع سرعة %who</translation>
    </message>
    <message>
        <source>Circle %3 came with %1 m/s and has %2 m/s after it. Both walls are hit in the same step, and each must turn its own part.</source>
        <translation>جاءت الدائرة ⁨%3⁩ بسرعة ⁦%1 m/s⁩ وسرعتها بعد ذلك ⁦%2 m/s⁩. يُصاب الجداران في الخطوة نفسها، وعلى كل منهما أن يعكس مركّبته.</translation>
    </message>
    <message>
        <source>When circle %1 was %2 m from the %3 its velocity stayed as it was, and that of the other changed, far from it and from every wall. A wall turns the circle that touches it, and no other.</source>
        <translation>حين كانت الدائرة ⁨%1⁩ على بعد ⁦%2 m⁩ من ⁨%3⁩ بقيت سرعتها كما هي، وتغيّرت سرعة الأخرى البعيدة عنها وعن كل جدار. الجدار يردّ الدائرة التي تلمسه ولا يردّ غيرها.</translation>
    </message>
    <message>
        <source>Beside a wall the velocity of another circle changes</source>
        <translation>بجانب جدار تتغير سرعة دائرة أخرى</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of walls and hits.</source>
        <translation>ما لم يصح هذا لا يمكن قول المزيد عن الجدران والتصادمات.</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of the walls.</source>
        <translation>ما لم يصح هذا لا يمكن قول المزيد عن الجدران.</translation>
    </message>
    <message>
        <source>Gravity leaves out steps of %who at the floor</source>
        <translation>عند الأرضية تُسقط الجاذبية خطوات من %who</translation>
    </message>
    <message>
        <source>Gravity acts twice in a step of %who at the floor</source>
        <translation>عند الأرضية تؤثر الجاذبية مرتين في خطوة من %who</translation>
    </message>
    <message>
        <source>Thrown down with %1 m/s, circle %2 was turned by the floor in step %3. In that step its velocity went from %4 to %5 m/s; %6 m/s is right: turned round, and with g Δt once. Gravity acts once in every step, also where a circle touches the floor.</source>
        <translation>رُميت الدائرة ⁨%2⁩ نحو الأسفل بسرعة ⁦%1 m/s⁩ فردّتها الأرضية في الخطوة ⁨%3⁩. في تلك الخطوة تغيّرت سرعتها من ⁦%4⁩ إلى ⁦%5 m/s⁩؛ والصحيح ⁦%6 m/s⁩: معكوسة ومعها ⁦g Δt⁩ مرة واحدة. تؤثر الجاذبية مرة واحدة في كل خطوة، حتى حيث تلمس الدائرة الأرضية.</translation>
    </message>
    <message>
        <source>Thrown down with %1 m/s, circle %2 was turned by the floor in step %3. In step %7 its velocity went from %4 to %5 m/s; %6 m/s is right. Gravity acts once in every step, also where a circle touches the floor.</source>
        <translation>رُميت الدائرة ⁨%2⁩ نحو الأسفل بسرعة ⁦%1 m/s⁩ فردّتها الأرضية في الخطوة ⁨%3⁩. وفي الخطوة ⁨%7⁩ تغيّرت سرعتها من ⁦%4⁩ إلى ⁦%5 m/s⁩؛ والصحيح ⁦%6 m/s⁩. تؤثر الجاذبية مرة واحدة في كل خطوة، حتى حيث تلمس الدائرة الأرضية.</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of the hits of the two circles.</source>
        <translation>ما لم يصح هذا لا يمكن قول المزيد عن تصادمات الدائرتين.</translation>
    </message>
    <message>
        <source>all at the very start of a run, none later</source>
        <translation>كلها في أول التشغيل تمامًا، ولا شيء منها بعد ذلك</translation>
    </message>
    <message>
        <source>all at the very start of a run, none from %1 s on</source>
        <translation>كلها في أول التشغيل تمامًا، ولا شيء منها ابتداءً من ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>Seen of circles that move apart, which your program answers as if they met; right is what the answer should make of these velocities.</source>
        <translation>شوهد هذا في دائرتين تتباعدان، يستجيب لهما برنامجك كأنهما تلتقيان؛ الصواب هو ما ينبغي أن تجعله الاستجابة من هاتين السرعتين.</translation>
    </message>
    <message>
        <source>The test of contact acts as if a number stood for %1</source>
        <translation>يعمل اختبار التلامس كأن عددًا يقوم مقام ⁨%1⁩</translation>
    </message>
    <message>
        <source>With all radii tried they answer where the distance of the centres is between %1 + %2 m and %1 + %3 m.</source>
        <translation>مع كل أنصاف الأقطار التي جُرّبت تستجيبان حيث تقع المسافة بين المركزين بين ⁦%1 + %2 m⁩ و⁦%1 + %3 m⁩.</translation>
    </message>
    <message>
        <source>The whole relative velocity is turned round</source>
        <translation>تنعكس السرعة النسبية كاملة</translation>
    </message>
    <message>
        <source>What turns the parts along the line of centres round does the same to those across. A smooth circle pushes along the line of centres only; each keeps its own part across.</source>
        <translation>ما يعكس المركّبتين على خط المركزين يفعل الشيء نفسه بالمركّبتين المعامدتين. الدائرة الملساء لا تدفع إلا على خط المركزين؛ وكلٌّ تحتفظ بمركّبتها المعامدة.</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m: </source>
        <translation>مع ⁦r₁ = %1⁩ و⁦r₂ = %2 m⁩: </translation>
    </message>
    <message>
        <source>Circles of different radii come out of a hit wrong</source>
        <translation>دائرتان مختلفتا نصف القطر تخرجان من التصادم على نحو خاطئ</translation>
    </message>
    <message>
        <source>Circles of the same radius come out right: look at where the radii enter what each of the two gets of the other.</source>
        <translation>دائرتان لهما نصف القطر نفسه تخرجان منه على نحو صحيح: انظر أين يدخل نصفا القطر في ما تأخذه كل منهما من الأخرى.</translation>
    </message>
    <message>
        <source>The size of the push hangs on the mass of circle %1 alone</source>
        <translation>مقدار الدفع يتوقف على كتلة الدائرة ⁨%1⁩ وحدها</translation>
    </message>
    <message>
        <source>In all hits tried both pushes are as large as if both circles had the mass of circle %1; what each makes of its own push is right. Look at which masses stand in the size of the push.</source>
        <translation>في كل التصادمات التي جُرّبت يكون الدفعان كبيرين كأن لكلتا الدائرتين كتلة الدائرة ⁨%1⁩؛ وما تجعله كلٌّ من دفعها صحيح. انظر أي كتل تدخل في مقدار الدفع.</translation>
    </message>
    <message>
        <source>Look at whether the normal has length 1 where they overlap.</source>
        <translation>انظر هل طول الناظم 1 حين تتداخلان.</translation>
    </message>
    <message>
        <source>Look at whether the normal has length 1 where it is made, before they touch.</source>
        <translation>انظر هل طول الناظم 1 حيث يُحسب، قبل أن تتلامسا.</translation>
    </message>
    <message>
        <source>How deep they overlap after a step is chance: it may move their places apart, but must not come into the velocities.</source>
        <translation>مقدار تداخلهما بعد خطوة أمر عارض: يجوز أن يباعد موضعيهما، ولا يجوز أن يدخل في السرعتين.</translation>
    </message>
    <message>
        <source>What a hit does depends on where in a step they touch</source>
        <translation>ما يفعله التصادم يتعلق باللحظة التي تتلامسان فيها من الخطوة</translation>
    </message>
    <message>
        <source>Where their rims touched after a quarter of a step of %1 s, they left with %2; where after two thirds, with %3; %4 are right.</source>
        <translation>حين تلامست الحافتان بعد ربع خطوة من %1 s خرجتا بـ %2؛ وبعد ثلثيها بـ %3؛ والصحيح %4.</translation>
    </message>
    <message>
        <source>%1 and %2 m/s</source>
        <translation>%1 و %2 m/s</translation>
    </message>
    <message>
        <source>Two equal circles met head-on with %1 and %2 m/s; e was %3.</source>
        <translation>التقت دائرتان متساويتان وجهًا لوجه بـ %1 و %2 m/s؛ وكان e يساوي %3.</translation>
    </message>
    <message>
        <source>Two equal circles met head-on with %1 and %2 m/s.</source>
        <translation>التقت دائرتان متساويتان وجهًا لوجه بـ %1 و %2 m/s.</translation>
    </message>
    <message>
        <source>In the step of the hit their velocities became %2 with a timestep of %1 s, and %4 with %3 s; %5 are right.</source>
        <translation>في خطوة التصادم صارت سرعتاهما %2 بخطوة زمنية %1 s، و%4 بخطوة %3 s؛ والصحيح %5.</translation>
    </message>
    <message>
        <source>A hit takes no time: look at where the timestep comes into what it does.</source>
        <translation>التصادم لا يستغرق زمنًا: انظر أين تدخل الخطوة الزمنية في ما يفعله.</translation>
    </message>
    <message>
        <source>What a hit does depends on the timestep</source>
        <translation>ما يفعله التصادم يتعلق بالخطوة الزمنية</translation>
    </message>
    <message>
        <source>A hit pushes circle %1 into the other one

In a step that would have brought their centres to %2 m from each other the hit put circle %1 %4 m nearer to the other one than its velocities before and after it take it; rims touch at %3 m. Each goes back to where it came from, or they are moved apart: look at the sign of the way that circle %1 is moved, and at whose velocity is in it.</source>
        <translation>يدفع التصادم الدائرة ⁨%1⁩ داخل الأخرى

في خطوة كانت ستجعل المسافة بين المركزين ⁦%2 m⁩ وضع التصادم الدائرة ⁨%1⁩ أقرب إلى الأخرى بمقدار ⁦%4 m⁩ مما تأخذها إليه سرعتاها قبله وبعده؛ وتتلامس الحافتان عند ⁦%3 m⁩. تعود كل منهما من حيث جاءت، أو يُباعَد بينهما: انظر إشارة المسافة التي تُزاح بها الدائرة ⁨%1⁩، وسرعة أي دائرة تدخل فيها.</translation>
    </message>
    <message>
        <source>A hit puts circle %1 too far away

In a step that would have brought their centres to %2 m from each other, where rims touch at %3 m, the hit put circle %1 %4 m farther from the other one than its velocities and twice that overlap explain. It is enough that they touch: look at how far it is moved.</source>
        <translation>يضع التصادم الدائرة ⁨%1⁩ أبعد مما ينبغي

في خطوة كانت ستجعل المسافة بين المركزين ⁦%2 m⁩، بينما تتلامس الحافتان عند ⁦%3 m⁩، وضع التصادم الدائرة ⁨%1⁩ أبعد عن الأخرى بمقدار ⁦%4 m⁩ مما تفسره سرعتاها وضعف ذلك التداخل. يكفي أن تتلامسا: انظر كم تُزاح.</translation>
    </message>
    <message>
        <source>A hit moves circle %1 to the side

In a step that would have brought their centres to %2 m from each other, where rims touch at %3 m, the hit put circle %1 %4 m to the side of the ways that its velocities before and after it take it. A hit may move circles apart along the line of centres only: look at the direction in which it is moved, and at whose velocity is in it.</source>
        <translation>يزيح التصادم الدائرة ⁨%1⁩ إلى الجانب

في خطوة كانت ستجعل المسافة بين المركزين ⁦%2 m⁩، بينما تتلامس الحافتان عند ⁦%3 m⁩، وضع التصادم الدائرة ⁨%1⁩ على بعد ⁦%4 m⁩ جانبًا عن المسارات التي تأخذها فيها سرعتاها قبله وبعده. لا يجوز أن يباعد التصادم بين الدائرتين إلا على امتداد خط المركزين: انظر الاتجاه الذي تُزاح إليه، وسرعة أي دائرة تدخل فيه.</translation>
    </message>
    <message>
        <source>At the %walls the density comes into the speed of %who</source>
        <translation>عند %walls تدخل الكثافة في السرعة، لـ %who</translation>
    </message>
    <message>
        <source>With ρ = %1 what comes back is %2 times the speed, with ρ = %3 it is %4 times; %5 is right.</source>
        <translation>مع ρ = %1 يعود %2 ضعفًا من السرعة، ومع ρ = %3 يعود %4؛ والصحيح %5.</translation>
    </message>
    <message>
        <source>In your own scene circle %1 turns too late at the walls</source>
        <translation>في مشهدك ترتدّ الدائرة ⁨%1⁩ عند الجدران متأخرة</translation>
    </message>
    <message>
        <source>In your own scene circle %1 turns too early at the walls</source>
        <translation>في مشهدك ترتدّ الدائرة ⁨%1⁩ عند الجدران مبكرة</translation>
    </message>
    <message>
        <source>Its radius is %1 m, and at the %2 it turned in a step that would have brought its centre from %3 to %4 m from the wall. In scenes that have their radii before your program begins it turns in time. Look at when your program reads the radii: what is read before `on_load` sets them is an old value.</source>
        <translation>نصف قطرها ⁦%1 m⁩، وعند ⁨%2⁩ ارتدّت في خطوة كانت ستنقل مركزها من ⁨%3⁩ إلى ⁦%4 m⁩ من الجدار. في المشاهد التي تكون أنصاف الأقطار فيها معطاة قبل أن يبدأ برنامجك ترتدّ في الوقت الصحيح. انظر متى يقرأ برنامجك أنصاف الأقطار: ما يُقرأ قبل أن يضبطها `on_load` قيمة قديمة.</translation>
    </message>
    <message>
        <source>The first step of the hit, of %1 s, left them with %2, step %3 of it with %4; %5 are right, from the first on.</source>
        <translation>تركتهما الخطوة الأولى من التصادم، وطولها %1 s، بـ %2، والخطوة %3 منه بـ %4؛ والصحيح %5، من الأولى فصاعدًا.</translation>
    </message>
    <message>
        <source>A hit takes no time: all that it changes is due in the step in which they touch.</source>
        <translation>التصادم لا يستغرق وقتًا: كل ما يغيّره يقع في الخطوة التي تتلامسان فيها.</translation>
    </message>
    <message>
        <source>The push of a hit is spread over several steps</source>
        <translation>دفع التصادم موزَّع على عدة خطوات</translation>
    </message>
    <message>
        <source>The first step of a run is made in another way.</source>
        <translation>الخطوة الأولى من التشغيل تُحسب بطريقة أخرى.</translation>
    </message>
    <message>
        <source>With its rim %1 m from the %2 and %3 m/s, circle %4 had %5 m/s one step of %6 s later; in free flight it has %7 m/s.</source>
        <translation>حين كان يفصل حافتها ⁦%1 m⁩ عن ⁨%2⁩ وسرعتها ⁦%3 m/s⁩، صارت سرعة الدائرة ⁨%4⁩ ⁦%5 m/s⁩ بعد خطوة واحدة من ⁦%6 s⁩؛ وفي الطيران الحر تكون ⁦%7 m/s⁩.</translation>
    </message>
    <message>
        <source>With its rim %1 m from the %2 and %3 m/s, circle %4 went %5 m in a step of %6 s; in free flight it goes %7 m.</source>
        <translation>حين كان يفصل حافتها ⁦%1 m⁩ عن ⁨%2⁩ وسرعتها ⁦%3 m/s⁩، تحركت الدائرة ⁨%4⁩ ⁦%5 m⁩ في خطوة من ⁦%6 s⁩؛ وفي الطيران الحر تتحرك ⁦%7 m⁩.</translation>
    </message>
    <message>
        <source>Near the %walls the steps of %who are made in another way</source>
        <translation>قرب %walls تُحسب خطوات %who بطريقة أخرى</translation>
    </message>
    <message>
        <source>Look at what your program asks there before its rim is at the wall.</source>
        <translation>انظر ما الذي يسأل عنه برنامجك هناك قبل أن تصل الحافة إلى الجدار.</translation>
    </message>
    <message>
        <source>After hits at the %walls the way of %who is not v Δt</source>
        <translation>بعد التصادمات عند %walls لا تتبع حركة %who السرعة</translation>
    </message>
    <message>
        <source>Another circle that is near changes the velocity of %who</source>
        <translation>دائرة أخرى قريبة تغيّر سرعة %who</translation>
    </message>
    <message>
        <source>In your own scene it starts with %1 m/s and has %2 m/s one step later; with every other circle set elsewhere it has %3 m/s then. In this step of the lab circles go through each other: look at what compares their places.</source>
        <translation>في مشهدك تنطلق بسرعة ⁦%1 m/s⁩ وتصير سرعتها ⁦%2 m/s⁩ بعد خطوة واحدة؛ ومع وضع كل الدوائر الأخرى في مكان آخر تكون ⁦%3 m/s⁩ حينئذ. في هذه المرحلة من المختبر تمر الدوائر بعضها عبر بعض: انظر ما الذي يقارن مواضعها.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits of unequal circles tried with e = %2, %n came out right: %3.</source>
        <translation>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين مع ⁦e = %2⁩، وعددها ⁨%1⁩، لم يصحّ أي تصادم: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ تصادم واحد: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ تصادمان: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n: %3.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين مع ⁦e = %2⁩، وعددها ⁨%1⁩، صحّ منها %n: %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits of unequal circles tried, %n came out right: %2.</source>
        <translation>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين، وعددها ⁨%1⁩، لم يصحّ أي تصادم: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين، وعددها ⁨%1⁩، صحّ تصادم واحد: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين، وعددها ⁨%1⁩، صحّ تصادمان: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين، وعددها ⁨%1⁩، صحّ منها %n: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين، وعددها ⁨%1⁩، صحّ منها %n: %2.</numerusform>
            <numerusform>من التصادمات المجرّبة لدائرتين غير متساويتين، وعددها ⁨%1⁩، صحّ منها %n: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Look at what the answer takes for e there, and at what is asked before it.</source>
        <translation>انظر ما الذي تأخذه الاستجابة هناك قيمةً لـ e، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>In all hits of equal circles tried the velocities changed along that line by whole numbers of m/s: look for what rounds a number, such as `//` or `math.floor`.</source>
        <translation>في كل التصادمات المجرّبة لدائرتين متساويتين تغيّرت السرعتان على ذلك الخط بأعداد صحيحة من ⁦m/s⁩: ابحث عمّا يقرّب عددًا، مثل ⁦`//`⁩ أو ⁦`math.floor`⁩.</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when their centres were %4 m apart.</source>
        <translation>مع ⁦r₁ = %1 m⁩ و⁦r₂ = %2 m⁩، واللقاء عند ⁦%3°⁩، استجابتا حين كانت المسافة بين مركزيهما ⁦%4 m⁩.</translation>
    </message>
    <message>
        <source>Where their rims touched after a quarter of a step of %1 s, they were answered; where after two thirds, they ran into each other.</source>
        <translation>حين تلامست الحافتان بعد ربع خطوة من ⁦%1 s⁩ استجابتا؛ وبعد ثلثيها دخلت إحداهما في الأخرى.</translation>
    </message>
    <message>
        <source>Where their rims touched after two thirds of a step of %1 s, they were answered; where after a quarter, they ran into each other.</source>
        <translation>حين تلامست الحافتان بعد ثلثي خطوة من ⁦%1 s⁩ استجابتا؛ وبعد ربعها دخلت إحداهما في الأخرى.</translation>
    </message>
    <message>
        <source>Whether a hit is answered depends on where in a step they touch</source>
        <translation>هل يُجاب عن التصادم يتوقف على موضع التلامس من الخطوة</translation>
    </message>
    <message>
        <source>Look at how the moment of the hit is worked out, and at what is done with circles that overlap already.</source>
        <translation>انظر كيف تُحسب لحظة التصادم، وماذا يُفعل بدائرتين متداخلتين أصلًا.</translation>
    </message>
    <message>
        <source>On the floor the speed of %who along it changes</source>
        <translation>على الأرضية تتغير السرعة الموازية لها، لـ %who</translation>
    </message>
    <message>
        <source>Circle %1 was let go %2 m above the floor with %3 m/s along it, and had %4 m/s along it %5 s later; %3 m/s is right. Where nothing rubs, a push points along the normal only: look at what slow hits at the floor change.</source>
        <translation>أُفلتت الدائرة ⁨%1⁩ على ارتفاع ⁦%2 m⁩ فوق الأرضية بسرعة ⁦%3 m/s⁩ موازية لها، وبعد ⁦%5 s⁩ كانت سرعتها الموازية ⁦%4 m/s⁩؛ الصواب ⁦%3 m/s⁩. حيث لا احتكاك لا تؤثر الدفعة إلا على امتداد الناظم: انظر ماذا تغيّر التصادمات البطيئة عند الأرضية.</translation>
    </message>
    <message>
        <source>Above the floor gravity stops moving %who</source>
        <translation>فوق الأرضية لا تعود الجاذبية تحرّك %who</translation>
    </message>
    <message>
        <source>Circle %1 was let go at rest %2 m above the floor, and from %3 s on it stood still %4 m above it, where nothing holds it. Look at what keeps a circle still, and at whether it lies on the floor then.</source>
        <translation>أُفلتت الدائرة ⁨%1⁩ ساكنة على ارتفاع ⁦%2 m⁩ فوق الأرضية، ومن ⁦%3 s⁩ فصاعدًا بقيت ساكنة على ارتفاع ⁦%4 m⁩ فوقها، حيث لا شيء يمسكها. انظر ما الذي يُبقي الدائرة ساكنة، وهل تكون حينئذ على الأرضية.</translation>
    </message>
    <message>
        <source>At the %walls the part along the wall comes into the rebound of %who</source>
        <translation>عند %walls تدخل المركّبة الموازية للجدار في الارتداد، لـ %who</translation>
    </message>
    <message>
        <source>With %1 m/s into the wall and %2 m/s along it, %3 times the part into it comes back; with %4 m/s along it %5 times. The part along a wall should not count there.</source>
        <translation>مع ⁦%1 m/s⁩ نحو الجدار و⁦%2 m/s⁩ موازية له ترجع المركّبة التي نحوه مضروبةً في ⁨%3⁩؛ ومع ⁦%4 m/s⁩ موازية له مضروبةً في ⁨%5⁩. ينبغي ألّا تُحسب هناك المركّبة الموازية للجدار.</translation>
    </message>
    <message>
        <source>A wall turns the speed round; no fixed amount is added to it or taken from it.</source>
        <translation>الجدار يعكس السرعة؛ لا يُضاف إليها مقدار ثابت ولا يُؤخذ منها.</translation>
    </message>
    <message>
        <source>Hits at the %walls take a fixed amount of speed from %who</source>
        <translation>التصادمات عند %walls تأخذ من سرعة %who مقدارًا ثابتًا</translation>
    </message>
    <message>
        <source>Hits at the %walls add a fixed amount of speed to %who</source>
        <translation>التصادمات عند %walls تضيف إلى سرعة %who مقدارًا ثابتًا</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with about %1 m/s too little.</source>
        <translation>من كل سرعة جُرّبت تغادر بما ينقص نحو ⁦%1 m/s⁩.</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with about %1 m/s too much.</source>
        <translation>من كل سرعة جُرّبت تغادر بما يزيد نحو ⁦%1 m/s⁩.</translation>
    </message>
    <message>
        <source>Its velocity points away from the wall only %1 s later, in steps of %2 s.</source>
        <translation>لا تشير سرعتها بعيدًا عن الجدار إلا بعد ⁦%1 s⁩، بخطوات من ⁦%2 s⁩.</translation>
    </message>
    <message>
        <source>In a step in which circle %1 hits a wall, circle %2 hits none</source>
        <translation>في الخطوة التي تصطدم فيها الدائرة ⁨%1⁩ بجدار لا تصطدم الدائرة ⁨%2⁩ بأي جدار</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, circle %2 came to the %3, and circle %5 with %4 m/s to the %6 in the same step: circle %2 was turned in it, and circle %5 was not. Alone it is. Look at what your program leaves out when the other circle is hit.</source>
        <translation>قُذفت الدائرة ⁨%2⁩ بسرعة ⁦%1 m/s⁩ فجاءت إلى ⁨%3⁩، وجاءت الدائرة ⁨%5⁩ بسرعة ⁦%4 m/s⁩ إلى ⁨%6⁩ في الخطوة نفسها: رُدّت فيها الدائرة ⁨%2⁩ ولم تُردّ الدائرة ⁨%5⁩. وحدها تُردّ. انظر ماذا يترك برنامجك حين تُصاب الدائرة الأخرى.</translation>
    </message>
    <message>
        <source>From every speed and with every e tried it leaves with about %1 m/s less than it came with.</source>
        <translation>من كل سرعة ومع كل e جُرّب تغادر بأقل مما جاءت به بنحو ⁦%1 m/s⁩.</translation>
    </message>
    <message>
        <source>From every speed and with every e tried it leaves with about %1 m/s more than it came with.</source>
        <translation>من كل سرعة ومع كل e جُرّب تغادر بأكثر مما جاءت به بنحو ⁦%1 m/s⁩.</translation>
    </message>
    <message>
        <source>The distance of circles that come nearer is less than in the step before: look at what your program compares with what it keeps from there.</source>
        <translation>المسافة بين دائرتين تقتربان أصغر مما كانت في الخطوة السابقة: انظر ما الذي يقارنه برنامجك بما يحتفظ به منها.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s it goes %3, %4, %5 and %6 m more than is right of the velocity before each.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ تحركت في الخطوات الأربع الأولى، ومدة كل منها ⁦%2 s⁩، زيادةً على الصحيح بحسب السرعة قبل كل منها بمقدار ⁦%3⁩ و⁦%4⁩ و⁦%5⁩ و⁦%6 m⁩.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s its velocity changes by %3, %4, %5 and %6 m/s more than is right.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ تغيرت سرعتها في الخطوات الأربع الأولى، ومدة كل منها ⁦%2 s⁩، زيادةً على الصحيح بمقدار ⁦%3⁩ و⁦%4⁩ و⁦%5⁩ و⁦%6 m/s⁩.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s it goes %3, %4, %5 and %6 m; %7 m is right in each.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ تحركت في الخطوات الأربع الأولى، ومدة كل منها ⁦%2 s⁩، بمقدار ⁦%3⁩ و⁦%4⁩ و⁦%5⁩ و⁦%6 m⁩؛ والصحيح في كل منها ⁦%7 m⁩.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s its velocity changes by %3, %4, %5 and %6 m/s; %7 m/s is right in each.</source>
        <translation>إذا انطلقت بسرعة ⁦%1 m/s⁩ تغيرت سرعتها في الخطوات الأربع الأولى، ومدة كل منها ⁦%2 s⁩، بمقدار ⁦%3⁩ و⁦%4⁩ و⁦%5⁩ و⁦%6 m/s⁩؛ والصحيح في كل منها ⁦%7 m/s⁩.</translation>
    </message>
    <message>
        <source>From step to step that grows by the same: look at what your program adds up, or counts, since the start.</source>
        <translation>من خطوة إلى التالية يزداد ذلك بالمقدار نفسه: انظر ما الذي يجمعه برنامجك أو يعدّه منذ البداية.</translation>
    </message>
    <message>
        <source>Look at what your program counts, or keeps from one step to the next, and at what is asked before these lines.</source>
        <translation>انظر ما الذي يعدّه برنامجك أو يحتفظ به من خطوة إلى التالية، وما الذي يُسأل عنه قبل هذه الأسطر.</translation>
    </message>
    <message>
        <source>Turned round at the %1, circle %2 has %3 m/s; in the next step of %4 s it went %5 m, and by that velocity it is %6 m.</source>
        <translation>بعد ارتدادها عند ⁨%1⁩ سرعة الدائرة ⁨%2⁩ هي ⁦%3 m/s⁩؛ وفي الخطوة التالية من ⁦%4 s⁩ تحركت ⁦%5 m⁩، وبحسب هذه السرعة تكون ⁦%6 m⁩.</translation>
    </message>
    <message>
        <source>So it goes in a run that begins there, too: look at what your program does with a circle that is at a wall and moves away from it.</source>
        <translation>وهكذا تتحرك أيضًا في تشغيل يبدأ من هناك: انظر ما الذي يفعله برنامجك بدائرة عند جدار وهي تبتعد عنه.</translation>
    </message>
    <message>
        <source>A velocity or an old place that your program keeps in a variable of its own must change at a hit, too.</source>
        <translation>والسرعة أو الموضع القديم الذي يحتفظ به برنامجك في متغير خاص به يجب أن يتغير هو أيضًا عند التصادم.</translation>
    </message>
    <message>
        <source>A step takes %who much farther than its velocity does</source>
        <translation>تنقل الخطوةُ %who أبعد بكثير مما تنقلها سرعتها</translation>
    </message>
    <message>
        <source>Started with %1 m/s, away from every wall and every other circle, it goes %2 m in the first step of %3 s; v Δt is %4 m. Look at which lines change the position, and at what is asked before them.</source>
        <translation>إذا بدأت بسرعة ⁦%1 m/s⁩ بعيدًا عن كل جدار وعن كل دائرة أخرى، قطعت ⁦%2 m⁩ في الخطوة الأولى ومدتها ⁦%3 s⁩؛ وقيمة v Δt هي ⁦%4 m⁩. انظر أيُّ الأسطر تغيّر الموضع، وما الذي يُسأل قبلها.</translation>
    </message>
    <message>
        <source>Your program sets it at %1 m, and one step later it is at %2 m: that step goes on from %3 m, where the scene has it.</source>
        <translation>يضعها برنامجك عند ⁦%1 m⁩، وبعد خطوة واحدة تكون عند ⁦%2 m⁩: فهذه الخطوة تنطلق من ⁦%3 m⁩، حيث يضعها المشهد.</translation>
    </message>
    <message>
        <source>Your program starts it with %1 m/s, and one step later it has %2 m/s: that step goes on from %3 m/s, which the scene gives it.</source>
        <translation>يبدأ بها برنامجك بسرعة ⁦%1 m/s⁩، وبعد خطوة واحدة تكون سرعتها ⁦%2 m/s⁩: فهذه الخطوة تنطلق من ⁦%3 m/s⁩، وهي ما يعطيها المشهد.</translation>
    </message>
    <message>
        <source>Your program sets it at %1 m with %2 m/s, and one step later it is at %3 m with %4 m/s: that step goes on from %5 m and %6 m/s, which the scene gives it.</source>
        <translation>يضعها برنامجك عند ⁦%1 m⁩ بسرعة ⁦%2 m/s⁩، وبعد خطوة واحدة تكون عند ⁦%3 m⁩ بسرعة ⁦%4 m/s⁩: فهذه الخطوة تنطلق من ⁦%5 m⁩ ومن ⁦%6 m/s⁩، وهي ما يعطيها المشهد.</translation>
    </message>
    <message>
        <source>The start of %who in your own scene is not taken over</source>
        <translation>لا تؤخذ بداية %who في مشهدك كما هي</translation>
    </message>
    <message>
        <source>A copy keeps the value of the moment when it was made: is it made before the start is set?</source>
        <translation>تحتفظ النسخة بقيمة اللحظة التي أُخذت فيها: فهل تؤخذ قبل ضبط البداية؟</translation>
    </message>
    <message>
        <source>In a corner one part of the velocity of %who turns round too late</source>
        <translation>في الزاوية ترتدّ مركّبة واحدة من سرعة %who متأخرة</translation>
    </message>
    <message>
        <source>Circle %1 came with %2 m/s and has %3 m/s after the step that brought it into the corner, with its rim %4 m beyond the %5. Both walls are hit in the same step, and each must turn its own part, whichever comes first.</source>
        <translation>جاءت الدائرة ⁨%1⁩ بسرعة ⁦%2 m/s⁩، وسرعتها ⁦%3 m/s⁩ بعد الخطوة التي أوصلتها إلى الزاوية، وحافتها على بعد ⁦%4 m⁩ وراء ⁨%5⁩. يُصدم الجداران في الخطوة نفسها، وعلى كل منهما أن يعكس مركّبته، أيهما جاء أولًا.</translation>
    </message>
    <message>
        <source>The hit changed the velocity of circle 1 by no more than %1 m/s and that of circle 2 by %2 m/s: look at what the push is multiplied by, and what it is divided by.</source>
        <translation>لم يغيّر التصادم سرعة الدائرة 1 بأكثر من ⁦%1 m/s⁩ وسرعة الدائرة 2 بأكثر من ⁦%2 m/s⁩: انظر بماذا تُضرب الدفعة وعلى ماذا تُقسم.</translation>
    </message>
</context>
<context>
    <name>FormulaWords</name>
    <message>
        <source>times</source>
        <translation>في</translation>
    </message>
    <message>
        <source>is at most</source>
        <translation>لا يتجاوز</translation>
    </message>
    <message>
        <source>is at least</source>
        <translation>لا يقل عن</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>لا يساوي</translation>
    </message>
    <message>
        <source>is about</source>
        <translation>يساوي تقريبًا</translation>
    </message>
    <message>
        <source>becomes</source>
        <translation>يصير</translation>
    </message>
    <message>
        <source>plus or minus</source>
        <translation>زائد أو ناقص</translation>
    </message>
    <message>
        <source>the sum of</source>
        <translation>مجموع</translation>
    </message>
    <message>
        <source>infinity</source>
        <translation>لانهاية</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>عمودي</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>موازٍ</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>درجة</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>فتحة</translation>
    </message>
    <message>
        <source>equals</source>
        <translation>يساوي</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>زائد</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>ناقص</translation>
    </message>
    <message>
        <source>over</source>
        <translation>على</translation>
    </message>
    <message>
        <source>is less than</source>
        <translation>أصغر من</translation>
    </message>
    <message>
        <source>is more than</source>
        <translation>أكبر من</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>بخط علوي</translation>
    </message>
    <message>
        <source>sub %1</source>
        <translation>بدليل ⁨%1⁩</translation>
    </message>
    <message>
        <source>squared</source>
        <translation>تربيع</translation>
    </message>
    <message>
        <source>cubed</source>
        <translation>تكعيب</translation>
    </message>
    <message>
        <source>to the power of %1</source>
        <translation>أُسّ ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <comment>a fraction</comment>
        <translation>⁨%1⁩ على ⁨%2⁩</translation>
    </message>
    <message>
        <source>the square root of %1</source>
        <translation>الجذر التربيعي لـ ⁨%1⁩</translation>
    </message>
    <message>
        <source>vector %1</source>
        <translation>المتجه ⁨%1⁩</translation>
    </message>
    <message>
        <source>unit vector %1</source>
        <translation>متجه الوحدة ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>Ghost</name>
    <message>
        <source>exact</source>
        <translation>دقيقة</translation>
    </message>
</context>
<context>
    <name>GlPainter</name>
    <message>
        <source>No OpenGL context can be made here</source>
        <translation>لا يمكن إنشاء سياق OpenGL هنا</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed, but %1 offers %2.%3</source>
        <translation>يلزم ⁦OpenGL 3.3⁩، لكن ⁨%1⁩ يوفّر ⁨%2⁩.⁨%3⁩</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed</source>
        <translation>يلزم ⁦OpenGL 3.3⁩</translation>
    </message>
    <message>
        <source>The shader %1 is missing</source>
        <translation>المظلِّل ⁨%1⁩ ناقص</translation>
    </message>
    <message>
        <source>The shader %1 does not compile: %2</source>
        <translation>المظلِّل ⁨%1⁩ لا يُترجَم: ⁨%2⁩</translation>
    </message>
    <message>
        <source>The shaders %1 do not link: %2</source>
        <translation>المظلِّلات ⁨%1⁩ لا تُربط: ⁨%2⁩</translation>
    </message>
    <message>
        <source>OpenGL has no memory for the scene</source>
        <translation>ليس لدى OpenGL ذاكرة للمشهد</translation>
    </message>
</context>
<context>
    <name>Grading</name>
    <message>
        <source>%1 is a link, which is not followed</source>
        <translation>⁨%1⁩ وصلة، ولا تُتبع</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a folder</source>
        <translation>⁨%1⁩ ليس ملفًا ولا مجلدًا</translation>
    </message>
    <message>
        <source>download of %1</source>
        <translation>تنزيل من ⁨%1⁩</translation>
    </message>
    <message>
        <source>Canvas says: late</source>
        <translation>يقول Canvas: متأخر</translation>
    </message>
    <message>
        <source>several attempts; the last one counts</source>
        <translation>محاولات عدة؛ تُحسب الأخيرة</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>مجلد</translation>
    </message>
    <message>
        <source>clone of GitHub Classroom</source>
        <translation>نسخة من ⁦GitHub Classroom⁩</translation>
    </message>
    <message>
        <source>%1 is no work of a student</source>
        <translation>⁨%1⁩ ليس عمل طالب</translation>
    </message>
    <message>
        <source>file</source>
        <translation>ملف</translation>
    </message>
    <message>
        <source>this is the work of one student; the folder that holds those of all is right</source>
        <translation>هذا عمل طالب واحد؛ الصواب المجلد الذي يضم أعمال الجميع</translation>
    </message>
    <message>
        <source>%1 handed in no file</source>
        <translation>لم يسلّم ⁨%1⁩ أي ملف</translation>
    </message>
    <message>
        <source>the process that judges was killed %1 times without getting anything done</source>
        <translation>قُتلت عملية الحكم دون أن تنجز شيئًا، وعدد مرات ذلك ⁨%1⁩</translation>
    </message>
    <message>
        <source>the process that judged it gave no verdict: %1</source>
        <translation>العملية التي حكمت عليه لم تصدر حكمًا: ⁨%1⁩</translation>
    </message>
    <message>
        <source>what judging found cannot be kept: %1</source>
        <translation>يتعذر حفظ ما وجده الحكم: ⁨%1⁩</translation>
    </message>
    <message>
        <source>this is no manifest of results of format 1</source>
        <translation>هذا ليس بيان نتائج بالصيغة 1</translation>
    </message>
    <message>
        <source>another process is writing results there</source>
        <translation>تكتب عملية أخرى نتائج هناك</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>⁨%1⁩ و⁨%2⁩ غيرها</translation>
    </message>
    <message>
        <source>%1: there are no results; its shard never began</source>
        <translation>⁨%1⁩: لا نتائج؛ لم يبدأ جزؤه قط</translation>
    </message>
    <message>
        <source>%1: shard %2 of %3 did not come to its end</source>
        <translation>⁨%1⁩: لم يبلغ الجزء ⁨%2⁩ من ⁨%3⁩ نهايته</translation>
    </message>
    <message>
        <source>none of these folders has results</source>
        <translation>ليس في أي من هذه المجلدات نتائج</translation>
    </message>
    <message>
        <source>judged more than once, with the same result: %1</source>
        <translation>حُكم عليه أكثر من مرة بالنتيجة نفسها: ⁨%1⁩</translation>
    </message>
    <message>
        <source>missing of %1 shards: %2</source>
        <translation>ينقص من الأجزاء الـ ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>without results: %1</source>
        <translation>بلا نتائج: ⁨%1⁩</translation>
    </message>
    <message>
        <source>these results are of another version of the lab, of Cradle or of the secret than those before; they cannot be put together</source>
        <translation>هذه نتائج نسخة أخرى من المختبر أو من Cradle أو من السرّ غير ما سبقها؛ لا يمكن جمعها</translation>
    </message>
    <message>
        <source>these results are of another class, or of another number of shards, than those before</source>
        <translation>هذه نتائج صف آخر، أو عدد آخر من الأجزاء، غير ما سبقها</translation>
    </message>
    <message>
        <source>%1: other isolation: %2</source>
        <translation>⁨%1⁩: عزل آخر: ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 is not as its manifest says, and is left out</source>
        <translation>⁨%1⁩ ليس كما يقول بيانه، فيُترك</translation>
    </message>
    <message>
        <source>the results of %1 differ from those in %2</source>
        <translation>نتائج ⁨%1⁩ تختلف عن التي في ⁨%2⁩</translation>
    </message>
    <message>
        <source>handed in</source>
        <translation>سلّموا</translation>
    </message>
    <message>
        <source>handed in nothing</source>
        <translation>لم يسلّموا شيئًا</translation>
    </message>
    <message>
        <source>pass every step</source>
        <translation>اجتازوا كل مرحلة</translation>
    </message>
    <message>
        <source>points on average</source>
        <translation>متوسط النقاط</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message>
        <source>steps not graded</source>
        <translation>مراحل لم تُقيَّم</translation>
    </message>
    <message>
        <source>Not graded</source>
        <translation>لم يُقيَّم</translation>
    </message>
    <message>
        <source>Here no verdict could be reached. These steps count neither as passed nor as failed, and the gradebooks leave the points of their students empty.</source>
        <translation>لم يمكن هنا الوصول إلى حكم. هذه المراحل لا تُحسب ناجحة ولا مخفقة، وتترك سجلات الدرجات نقاط طلابها فارغة.</translation>
    </message>
    <message>
        <source>%1: the roster has %2, what was handed in has %3; judged with the values of %2.</source>
        <translation>⁨%1⁩: في القائمة ⁨%2⁩، وفيما سُلِّم ⁨%3⁩؛ حُكم عليه بقيم ⁨%2⁩.</translation>
    </message>
    <message>
        <source>%1 stands in what several handed in: %2.</source>
        <translation>⁨%1⁩ وارد فيما سلّمه عدة طلاب: ⁨%2⁩.</translation>
    </message>
    <message>
        <source>Numbers that are not clear</source>
        <translation>أرقام غير واضحة</translation>
    </message>
    <message>
        <source>This lab draws values by a student&apos;s number: that of the roster, where it has one, else that of what was handed in. A mistyped number is likelier than anything else.</source>
        <translation>يختار هذا المختبر القيم بحسب رقم الطالب: الرقم الذي في القائمة إن وُجد، وإلا فرقم ما سُلِّم. الخطأ في كتابة الرقم أرجح من أي شيء آخر.</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>و⁨%1⁩ غيرها.</translation>
    </message>
    <message>
        <source>Handed in nothing</source>
        <translation>لم يسلّموا شيئًا</translation>
    </message>
    <message>
        <source>How it was judged</source>
        <translation>كيف جرى الحكم</translation>
    </message>
    <message>
        <source>By %1, with version %2 of the lab %3 (sha256 %4).</source>
        <translation>بواسطة ⁨%1⁩، بالنسخة ⁨%2⁩ من المختبر ⁨%3⁩ (⁦sha256 %4⁩).</translation>
    </message>
    <message>
        <source>Programs were kept apart by: %1.</source>
        <translation>فُصلت البرامج بعضها عن بعض بواسطة: ⁨%1⁩.</translation>
    </message>
    <message>
        <source>A step is worth what the lab says, else the points of its checks; a check that passes brings its points also where others fail. Points are rounded to the hundredth, halves up, once, after all else.</source>
        <translation>قيمة المرحلة ما يقوله المختبر، وإلا فنقاط فحوصها؛ والفحص الذي يُجتاز يأتي بنقاطه حتى إن أخفقت أخرى. تُقرَّب النقاط إلى جزء من مئة، والأنصاف إلى الأعلى، مرة واحدة، بعد كل شيء.</translation>
    </message>
    <message>
        <source>Each day late that has begun takes %1 % of the points, at most %2 %.</source>
        <translation>كل يوم تأخير بدأ يأخذ ⁦%1 %⁩ من النقاط، وعلى الأكثر ⁦%2 %⁩.</translation>
    </message>
    <message>
        <source>Handing in late takes no points.</source>
        <translation>التسليم المتأخر لا يأخذ نقاطًا.</translation>
    </message>
    <message>
        <source>For the teacher alone: this page has names. What students read of themselves is in the folder students.</source>
        <translation>للمدرّس وحده: في هذه الصفحة أسماء. ما يقرؤه الطلاب عن أنفسهم في المجلد students.</translation>
    </message>
    <message>
        <source>How it starts</source>
        <translation>كيف يبدأ</translation>
    </message>
    <message>
        <source>Free motion</source>
        <translation>الحركة الحرّة</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>الجدران</translation>
    </message>
    <message>
        <source>When two touch</source>
        <translation>حين تتلامس اثنتان</translation>
    </message>
    <message>
        <source>What a hit does</source>
        <translation>ما يفعله التصادم</translation>
    </message>
    <message>
        <source>In the long run</source>
        <translation>على المدى الطويل</translation>
    </message>
    <message>
        <source>Students with a finding</source>
        <translation>طلاب لديهم تشخيص</translation>
    </message>
    <message>
        <source>The program stops</source>
        <translation>يتوقف البرنامج</translation>
    </message>
    <message>
        <source>an example</source>
        <translation>مثال</translation>
    </message>
    <message>
        <source>%1 of %2 do not pass</source>
        <translation>⁨%1⁩ من ⁨%2⁩ لا يجتازون</translation>
    </message>
    <message>
        <source>Where the class stands</source>
        <translation>أين يقف الصف</translation>
    </message>
    <message>
        <source>How many pass each step</source>
        <translation>كم يجتازون كل مرحلة</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>يجتازون</translation>
    </message>
    <message>
        <source>do not pass yet</source>
        <translation>لا يجتازون بعد</translation>
    </message>
    <message>
        <source>not graded</source>
        <translation>لم يُقيَّم</translation>
    </message>
    <message>
        <source>not handed in</source>
        <translation>لم يُسلَّم</translation>
    </message>
    <message>
        <source>What the class misunderstood</source>
        <translation>ما أساء الصف فهمه</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>لم يُعثر على شيء.</translation>
    </message>
    <message>
        <source>How many students have a finding of that sort in that step; the stronger the colour, the larger their part of those who were judged. The examples are of one student each, without names and comments.</source>
        <translation>كم طالبًا لديه تشخيص من ذلك النوع في تلك المرحلة؛ وكلما قوي اللون كبر نصيبهم ممن حُكم عليهم. كل مثال من طالب واحد، بلا أسماء ولا تعليقات.</translation>
    </message>
    <message>
        <source>Checks that tell nobody apart</source>
        <translation>فحوص لا تميّز أحدًا</translation>
    </message>
    <message>
        <source>In brackets: how many were judged by it.</source>
        <translation>بين القوسين: كم حُكم عليه به.</translation>
    </message>
    <message>
        <source>Nobody passes</source>
        <translation>لا يجتاز أحد</translation>
    </message>
    <message>
        <source>Everybody passes</source>
        <translation>يجتاز الجميع</translation>
    </message>
    <message>
        <source>Checks and time on the way</source>
        <translation>الفحوص والوقت في الطريق</translation>
    </message>
    <message>
        <source>Of those who handed in a history, as it says itself. Minutes are those in which the program changed, without pauses of more than ten; who thinks on paper shows none. A history of commits alone tells no checks.</source>
        <translation>لمن سلّموا تاريخًا، كما يقول هو نفسه. الدقائق هي التي تغيّر فيها البرنامج، دون توقفات تزيد على عشر؛ ومن يفكر على الورق لا يظهر له شيء. تاريخ من الإيداعات وحدها لا يخبر عن فحوص.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>المرحلة</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>الطلاب</translation>
    </message>
    <message>
        <source>Checks, median</source>
        <translation>الفحوص، الوسيط</translation>
    </message>
    <message>
        <source>Checks, most</source>
        <translation>الفحوص، الأكثر</translation>
    </message>
    <message>
        <source>Minutes, median</source>
        <translation>الدقائق، الوسيط</translation>
    </message>
    <message>
        <source>Programs that are alike</source>
        <translation>برامج متشابهة</translation>
    </message>
    <message>
        <source>Compared token by token, whatever their names, comments and order (winnowing). What the lab gives is left out, and so is what more than %1 students share. There are many good reasons for programs to be alike: working together where that is allowed, the same book, the same idea. A pair below proves nothing; read both, and ask.</source>
        <translation>قورنت رمزًا رمزًا، مهما كانت أسماؤها وتعليقاتها وترتيبها ⁦(winnowing)⁩. يُترك ما يعطيه المختبر، وكذلك ما يشترك فيه من الطلاب أكثر من ⁨%1⁩. للتشابه أسباب وجيهة كثيرة: العمل معًا حيث يُسمح به، أو الكتاب نفسه، أو الفكرة نفسها. الزوج أدناه لا يثبت شيئًا؛ اقرأ كليهما واسأل.</translation>
    </message>
    <message>
        <source>There are none.</source>
        <translation>لا يوجد شيء منها.</translation>
    </message>
    <message>
        <source>share %1 % of what the one with less has of their own</source>
        <translation>يشتركان في ⁦%1 %⁩ مما هو خاص بأقلّهما</translation>
    </message>
    <message>
        <source>Who is where</source>
        <translation>من وصل إلى أين</translation>
    </message>
    <message>
        <source>✓ passes, ○ does not pass yet, · not handed in, ? not graded</source>
        <translation>✓ يجتاز، ○ لا يجتاز بعد، · لم يُسلَّم، ? لم يُقيَّم</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>الطالب</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>اجتيزت</translation>
    </message>
    <message>
        <source>points</source>
        <translation>النقاط</translation>
    </message>
    <message>
        <source>this is the result of &quot;%1&quot;, whose file has another name</source>
        <translation>هذه نتيجة &quot;⁨%1⁩&quot;، ولملفها اسم آخر</translation>
    </message>
    <message>
        <source>the roster has %1 more than once</source>
        <translation>في القائمة ⁨%1⁩ أكثر من مرة</translation>
    </message>
    <message>
        <source>%1 is not in the roster</source>
        <translation>⁨%1⁩ ليس في القائمة</translation>
    </message>
    <message>
        <source>there are more than %1 files in it</source>
        <translation>فيه أكثر من ⁨%1⁩ ملف</translation>
    </message>
    <message>
        <source>a broken entry</source>
        <translation>مدخل تالف</translation>
    </message>
    <message>
        <source>it holds absurdly much</source>
        <translation>حجم محتواه غير معقول</translation>
    </message>
    <message>
        <source>this is no zip: %1</source>
        <translation>هذا ليس ملف zip: ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass</source>
        <translation>المراحل المجتازة: ⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 not graded</source>
        <translation>⁨%1⁩ لم تُقيَّم</translation>
    </message>
    <message>
        <source>Nothing was handed in</source>
        <translation>لم يُسلَّم شيء</translation>
    </message>
    <message>
        <source>and %1 more of that sort</source>
        <translation>و⁨%1⁩ غيرها من ذلك النوع</translation>
    </message>
    <message>
        <source>%1 was passed over for %2</source>
        <translation>استُغني عن ⁨%1⁩ واعتُمد ⁨%2⁩</translation>
    </message>
    <message>
        <source>nothing that was handed in is a program</source>
        <translation>ليس فيما سُلِّم برنامج</translation>
    </message>
    <message>
        <source>%1 is not looked into; unpack it in its place</source>
        <translation>لا يُنظر داخل ⁨%1⁩؛ فكّ ضغطه في مكانه</translation>
    </message>
    <message>
        <source>the history is too large to be looked at</source>
        <translation>التاريخ أكبر من أن يُنظر فيه</translation>
    </message>
    <message>
        <source>an object is right here</source>
        <translation>الصواب هنا كائن</translation>
    </message>
    <message>
        <source>%1 is right here</source>
        <translation>الصواب هنا ⁨%1⁩</translation>
    </message>
    <message>
        <source>a text of at most %1 letters</source>
        <translation>نص من ⁨%1⁩ حرفًا على الأكثر</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>عدد من ⁨%1⁩ إلى ⁨%2⁩</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>عدد صحيح من ⁨%1⁩ إلى ⁨%2⁩</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>‏true أو false</translation>
    </message>
    <message>
        <source>a list of at most %1</source>
        <translation>قائمة من ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>كائن</translation>
    </message>
    <message>
        <source>judging took more than %1 s of processor time</source>
        <translation>استغرق الحكم أكثر من ⁦%1 s⁩ من وقت المعالج</translation>
    </message>
    <message>
        <source>not judged: the program cannot be read</source>
        <translation>لم يُحكم عليه: تتعذر قراءة البرنامج</translation>
    </message>
    <message>
        <source>the lab has no step %1</source>
        <translation>ليس في المختبر مرحلة ⁨%1⁩</translation>
    </message>
    <message>
        <source>the file that was handed in cannot be read: %1</source>
        <translation>تتعذر قراءة الملف الذي سُلِّم: ⁨%1⁩</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>لا ⁨%1⁩</translation>
    </message>
    <message>
        <source>The program around line %1</source>
        <translation>البرنامج حول السطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>this is no folder</source>
        <translation>هذا ليس مجلدًا</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>تتعذر قراءته: ⁨%1⁩</translation>
    </message>
    <message>
        <source>this is a link that leads elsewhere; it is not followed</source>
        <translation>هذه وصلة تقود إلى مكان آخر؛ لا تُتبع</translation>
    </message>
    <message>
        <source>this is no plain file</source>
        <translation>هذا ليس ملفًا عاديًا</translation>
    </message>
    <message>
        <source>this is no roster: its first line has neither a column &quot;id&quot; nor a column &quot;folder&quot;</source>
        <translation>هذه ليست قائمة صف: ليس في سطرها الأول عمود ⁦&quot;id&quot;⁩ ولا عمود ⁦&quot;folder&quot;⁩</translation>
    </message>
    <message>
        <source>row %1 names nobody: it has neither an id nor a folder</source>
        <translation>الصف ⁨%1⁩ لا يسمّي أحدًا: ليس فيه معرّف ولا مجلد</translation>
    </message>
    <message>
        <source>row %1: late days are a number from 0</source>
        <translation>الصف ⁨%1⁩: أيام التأخير عدد ابتداء من 0</translation>
    </message>
    <message>
        <source>Judged by %1, version %2 of the lab, in scenes drawn for this student alone.</source>
        <translation>حكم عليه ⁨%1⁩، بالنسخة ⁨%2⁩ من المختبر، في مشاهد اختيرت لهذا الطالب وحده.</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>النقاط: ⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message>
        <source>Steps that could not be graded: %1. There is no sum of points yet; that is not the fault of what was handed in.</source>
        <translation>مراحل تعذّر تقييمها: ⁨%1⁩. لا يوجد مجموع نقاط بعد؛ وليس ذلك ذنب ما سُلِّم.</translation>
    </message>
    <message>
        <source>Days late, a begun one counted whole: %1. That takes %2 % of the points; the sum above has them taken off already.</source>
        <translation>أيام التأخير، واليوم الذي بدأ يُحسب كاملًا: ⁨%1⁩. يأخذ ذلك ⁦%2 %⁩ من النقاط؛ وقد خُصمت من المجموع أعلاه.</translation>
    </message>
    <message>
        <source>What was handed in has the number %2, which the roster does not have for this student: it was judged with the values that are drawn by the number %1.</source>
        <translation>رقم ما سُلِّم هو ⁨%2⁩، وليس لهذا الطالب في القائمة: حُكم عليه بالقيم التي تُختار بالرقم ⁨%1⁩.</translation>
    </message>
    <message>
        <source>The values of this lab were drawn by the number %1.</source>
        <translation>اختيرت قيم هذا المختبر بالرقم ⁨%1⁩.</translation>
    </message>
    <message>
        <source>✓ passes</source>
        <translation>✓ يجتاز</translation>
    </message>
    <message>
        <source>– not handed in</source>
        <translation>– لم يُسلَّم</translation>
    </message>
    <message>
        <source>? not graded</source>
        <translation>? لم يُقيَّم</translation>
    </message>
    <message>
        <source>! stops with an error</source>
        <translation>! يتوقف بخطأ</translation>
    </message>
    <message>
        <source>○ does not pass yet</source>
        <translation>○ لا يجتاز بعد</translation>
    </message>
    <message>
        <source>! cannot be read</source>
        <translation>! تتعذر قراءته</translation>
    </message>
    <message>
        <source>– of %1</source>
        <translation>– من ⁨%1⁩</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>الحكم</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>النقاط</translation>
    </message>
    <message>
        <source>Nothing was handed in for this step.</source>
        <translation>لم يُسلَّم شيء لهذه المرحلة.</translation>
    </message>
    <message>
        <source>There is no verdict: this step counts neither as passed nor as failed.</source>
        <translation>لا يوجد حكم: هذه المرحلة لا تُحسب ناجحة ولا مخفقة.</translation>
    </message>
    <message numerus="yes">
        <source>Checked %n time(s) while working on it.</source>
        <translation>
            <numerusform>لم يُفحص قط أثناء العمل عليه.</numerusform>
            <numerusform>فُحص مرة واحدة أثناء العمل عليه.</numerusform>
            <numerusform>فُحص مرتين أثناء العمل عليه.</numerusform>
            <numerusform>فُحص %n مرات أثناء العمل عليه.</numerusform>
            <numerusform>فُحص %n مرة أثناء العمل عليه.</numerusform>
            <numerusform>فُحص %n مرة أثناء العمل عليه.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program stopped in step %1 of a scene, at %2 s.</source>
        <translation>توقف البرنامج في الخطوة ⁨%1⁩ من مشهد، عند ⁦%2 s⁩.</translation>
    </message>
    <message>
        <source>The program does not load.</source>
        <translation>البرنامج لا يُحمَّل.</translation>
    </message>
    <message>
        <source>The program stopped before its first step.</source>
        <translation>توقف البرنامج قبل خطوته الأولى.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>السطر ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>There:</source>
        <translation>هناك:</translation>
    </message>
    <message>
        <source>Look at line %1 of your program.</source>
        <translation>انظر إلى السطر ⁨%1⁩ من برنامجك.</translation>
    </message>
    <message>
        <source>It is reached by the calls in line %1.</source>
        <translation>تصل إليه الاستدعاءات في السطر ⁧%1⁩.</translation>
    </message>
    <message>
        <source>“%1” first goes wrong here, at %2 s.</source>
        <translation>أول خطأ في «⁨%1⁩» يظهر هنا، عند ⁦%2 s⁩.</translation>
    </message>
    <message>
        <source>“%1” goes wrong from the start.</source>
        <translation>الخطأ في «⁨%1⁩» قائم منذ البداية.</translation>
    </message>
    <message>
        <source>Scene: %1.</source>
        <translation>المشهد: ⁨%1⁩.</translation>
    </message>
    <message>
        <source>The checks of this step</source>
        <translation>فحوص هذه المرحلة</translation>
    </message>
    <message>
        <source>did not pass</source>
        <translation>لم يُجتز</translation>
    </message>
    <message>
        <source>there is no such aspect</source>
        <translation>لا يوجد جانب كهذا</translation>
    </message>
    <message>
        <source>there is no such kind of error</source>
        <translation>لا يوجد نوع خطأ كهذا</translation>
    </message>
    <message>
        <source>a colour like #1e90ff is right</source>
        <translation>الصواب لون مثل ⁦#1e90ff⁩</translation>
    </message>
    <message>
        <source>there is no such status</source>
        <translation>لا توجد حالة كهذه</translation>
    </message>
    <message>
        <source>the status and the report say different things</source>
        <translation>الحالة والتقرير يقولان شيئين مختلفين</translation>
    </message>
    <message>
        <source>the result is too large</source>
        <translation>النتيجة كبيرة جدًّا</translation>
    </message>
    <message>
        <source>this is no result of a student: %1</source>
        <translation>هذه ليست نتيجة طالب: ⁨%1⁩</translation>
    </message>
    <message>
        <source>not a JSON object</source>
        <translation>ليس كائن JSON</translation>
    </message>
    <message>
        <source>this is no secret: at least %1 letters are right</source>
        <translation>هذا ليس سرًّا: الصواب ⁨%1⁩ حرفًا على الأقل</translation>
    </message>
    <message>
        <source>no process to judge in can be started: %1</source>
        <translation>تعذّر بدء عملية للحكم فيها: ⁨%1⁩</translation>
    </message>
    <message>
        <source>it has sent too much</source>
        <translation>أرسلت أكثر مما ينبغي</translation>
    </message>
    <message>
        <source>it has sent what it was not asked for</source>
        <translation>أرسلت ما لم يُطلب منها</translation>
    </message>
    <message>
        <source>it tried what no judgement needs, and was stopped</source>
        <translation>حاولت ما لا يحتاج إليه أي حكم، فأُوقفت</translation>
    </message>
    <message>
        <source>it was ended by signal %1</source>
        <translation>أنهتها الإشارة ⁨%1⁩</translation>
    </message>
    <message>
        <source>it broke down</source>
        <translation>انهارت</translation>
    </message>
    <message>
        <source>of the names of Blackboard, what follows the last _ is taken for the account; a roster tells better</source>
        <translation>في أسماء ⁦Blackboard⁩ يُعدّ ما بعد آخر ⁦_⁩ اسمَ الحساب؛ وقائمة الصف أدقّ</translation>
    </message>
    <message>
        <source>of the names of Blackboard, what follows %1 is taken for the account; a roster tells better</source>
        <translation>في أسماء ⁦Blackboard⁩ يُعدّ ما بعد ⁨%1⁩ اسمَ الحساب؛ وقائمة الصف أدقّ</translation>
    </message>
    <message>
        <source>%1: too large to be unpacked</source>
        <translation>⁨%1⁩: أكبر من أن يُفك ضغطه</translation>
    </message>
    <message>
        <source>%1: left out %2</source>
        <translation>⁨%1⁩: لم يؤخذ ⁨%2⁩</translation>
    </message>
    <message>
        <source>names that are in it more than once</source>
        <translation>أسماء ترد فيه أكثر من مرة</translation>
    </message>
    <message>
        <source>this is the zip of a whole class; grade the zip itself</source>
        <translation>هذا ملف zip لصف كامل؛ قيّم ملف zip نفسه</translation>
    </message>
    <message>
        <source>cannot be unpacked: %1</source>
        <translation>يتعذر فك ضغطه: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>HandIn</name>
    <message>
        <source>the work cannot be put there</source>
        <translation>لا يمكن وضع العمل هناك</translation>
    </message>
    <message>
        <source>this is no folder with a student&apos;s work</source>
        <translation>هذا ليس مجلدًا فيه عمل طالب</translation>
    </message>
    <message>
        <source>this is no work that was handed in: there is no manifest.json of format 1 in it</source>
        <translation>هذا ليس عملًا سُلِّم: ليس فيه ⁦manifest.json⁩ بالصيغة 1</translation>
    </message>
    <message>
        <source>this file is not in the manifest</source>
        <translation>هذا الملف ليس في البيان</translation>
    </message>
    <message>
        <source>this file was changed after it was handed in</source>
        <translation>غُيّر هذا الملف بعد تسليمه</translation>
    </message>
    <message>
        <source>this file is missing</source>
        <translation>هذا الملف ناقص</translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message numerus="yes">
        <source>Move %n circles</source>
        <translation>
            <numerusform>نقل %n من الدوائر</numerusform>
            <numerusform>نقل دائرة واحدة</numerusform>
            <numerusform>نقل دائرتين</numerusform>
            <numerusform>نقل %n دوائر</numerusform>
            <numerusform>نقل %n دائرة</numerusform>
            <numerusform>نقل %n دائرة</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>نقل ⁨%1⁩</translation>
    </message>
    <message numerus="yes">
        <source>Change velocities of %n circles</source>
        <translation>
            <numerusform>تغيير سرعات %n من الدوائر</numerusform>
            <numerusform>تغيير سرعة دائرة واحدة</numerusform>
            <numerusform>تغيير سرعتي دائرتين</numerusform>
            <numerusform>تغيير سرعات %n دوائر</numerusform>
            <numerusform>تغيير سرعات %n دائرة</numerusform>
            <numerusform>تغيير سرعات %n دائرة</numerusform>
        </translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation>تغيير سرعة ⁨%1⁩</translation>
    </message>
    <message>
        <source>changed by %1 m/s</source>
        <translation>تغيّرت بمقدار ⁦%1 m/s⁩</translation>
    </message>
    <message>
        <source>%1 m/s, speed %2 m/s</source>
        <translation>⁦%1 m/s⁩، مقدار السرعة ⁦%2 m/s⁩</translation>
    </message>
    <message>
        <source>moved by %1 m</source>
        <translation>انتقلت بمقدار ⁦%1 m⁩</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>⁦%1 m⁩</translation>
    </message>
</context>
<context>
    <name>HitNote</name>
    <message>
        <source>%1: %2</source>
        <comment>title, rows</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>before</source>
        <translation>قبل</translation>
    </message>
    <message>
        <source>after</source>
        <translation>بعد</translation>
    </message>
    <message>
        <source>change</source>
        <translation>التغير</translation>
    </message>
    <message>
        <source>%1 before %2, after %3, change %4 %5</source>
        <comment>who, three numbers, unit</comment>
        <translation>⁨%1⁩ قبل ⁨%2⁩، بعد ⁨%3⁩، التغير ⁦%4 %5⁩</translation>
    </message>
    <message>
        <source>Hit %1 · %2 s</source>
        <translation>التصادم ⁨%1⁩ · ⁦%2 s⁩</translation>
    </message>
    <message>
        <source> · first of %1</source>
        <translation> · الأول من ⁨%1⁩</translation>
    </message>
    <message>
        <source>both</source>
        <translation>كلتاهما</translation>
    </message>
</context>
<context>
    <name>HitParts</name>
    <message>
        <source>before %1</source>
        <translation>قبل ⁨%1⁩</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>بعد ⁨%1⁩</translation>
    </message>
    <message>
        <source>n</source>
        <comment>the normal vector</comment>
        <translation>n</translation>
    </message>
    <message>
        <source>across %1</source>
        <translation>معامدة ⁨%1⁩</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>على الخط ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>LabArchive</name>
    <message>
        <source>the lab cannot be put there</source>
        <translation>لا يمكن وضع المختبر هناك</translation>
    </message>
    <message>
        <source>the lab cannot be packed: %1</source>
        <translation>لا يمكن حزم المختبر: ⁨%1⁩</translation>
    </message>
    <message>
        <source>there is no lab.json</source>
        <translation>لا يوجد ⁦lab.json⁩</translation>
    </message>
    <message>
        <source>there are %1 files in it; at most %2 are right</source>
        <translation>فيه ⁨%1⁩ ملفًا؛ الصواب ⁨%2⁩ على الأكثر</translation>
    </message>
    <message>
        <source>the name is not in UTF-8, which would be right</source>
        <translation>الاسم ليس بترميز ⁦UTF-8⁩، وهو الصواب</translation>
    </message>
    <message>
        <source>this is a link or a special file; a plain file is right</source>
        <translation>هذه وصلة أو ملف خاص؛ الصواب ملف عادي</translation>
    </message>
    <message>
        <source>this is encrypted; a file without a password is right</source>
        <translation>هذا مشفَّر؛ الصواب ملف بلا كلمة مرور</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>الملف كبير جدًّا؛ الصواب ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>this unpacks to more than %1 times its size, as no honest file does</source>
        <translation>يُفكّ ضغط هذا إلى أكثر من ⁨%1⁩ ضعف حجمه، وهو ما لا يفعله ملف سليم</translation>
    </message>
    <message>
        <source>all of it is too large; at most %1 are right</source>
        <translation>المجموع كبير جدًّا؛ الصواب ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>the name is there twice (but for capital letters); a name of its own is right</source>
        <translation>الاسم وارد مرتين (مع اختلاف الأحرف الكبيرة فقط)؛ الصواب اسم خاص به</translation>
    </message>
    <message>
        <source>this unpacks to another size than it says</source>
        <translation>يُفكّ ضغط هذا إلى حجم غير المذكور فيه</translation>
    </message>
    <message>
        <source>this is broken or packed in an unknown way</source>
        <translation>هذا تالف أو مضغوط بطريقة غير معروفة</translation>
    </message>
    <message>
        <source>there is no %1 in it</source>
        <translation>ليس فيه ⁨%1⁩</translation>
    </message>
    <message>
        <source>this is no archive: %1</source>
        <translation>هذا ليس أرشيفًا: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>LabEdits</name>
    <message>
        <source>&quot;%1&quot; cannot be the name of a step; letters, digits, dashes and underscores are right</source>
        <translation>لا يمكن أن يكون &quot;⁨%1⁩&quot; اسم مرحلة؛ الصواب أحرف لاتينية وأرقام وشرطات وشرطات سفلية</translation>
    </message>
    <message>
        <source>the lab has a folder %1 already</source>
        <translation>في المختبر مجلد ⁨%1⁩ بالفعل</translation>
    </message>
    <message>
        <source>the lab has no step in the folder %1</source>
        <translation>ليس في المختبر مرحلة في المجلد ⁨%1⁩</translation>
    </message>
    <message>
        <source>the lab has translations into this language; its own texts are in another</source>
        <translation>في المختبر ترجمات إلى هذه اللغة؛ ونصوصه الأصلية بلغة أخرى</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be the name of a program; letters, digits, dots, dashes and underscores are right</source>
        <translation>لا يمكن أن يكون &quot;⁨%1⁩&quot; اسم برنامج؛ الصواب أحرف لاتينية وأرقام ونقاط وشرطات وشرطات سفلية</translation>
    </message>
    <message>
        <source>the step has a program of this name already</source>
        <translation>في المرحلة برنامج بهذا الاسم بالفعل</translation>
    </message>
    <message>
        <source>there is no such program</source>
        <translation>لا يوجد برنامج كهذا</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>تتعذر قراءته: لا يوجد ملف كهذا</translation>
    </message>
</context>
<context>
    <name>LabFiles</name>
    <message>
        <source>this is a link that leads to no file of the lab; a file of its own is right</source>
        <translation>هذه وصلة لا تقود إلى ملف من المختبر؛ الصواب ملف خاص به</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>هذا مجلد؛ الصواب ملف</translation>
    </message>
    <message>
        <source>folders are nested too deeply; at most %1 are right</source>
        <translation>المجلدات متداخلة أعمق مما ينبغي؛ الصواب ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>this is neither a file nor a folder</source>
        <translation>هذا ليس ملفًا ولا مجلدًا</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>الملف كبير جدًّا؛ الصواب ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>the lab is too large from here on; at most %1 files and %2 are right</source>
        <translation>المختبر أكبر مما ينبغي من هنا فصاعدًا؛ الصواب ⁨%1⁩ ملفًا و⁨%2⁩ على الأكثر</translation>
    </message>
    <message>
        <source>a path that stays in the lab is right, of names that do not begin with a dot</source>
        <translation>الصواب مسار يبقى في المختبر، بأسماء لا تبدأ بنقطة</translation>
    </message>
    <message>
        <source>the name is too long; at most %1 characters are right</source>
        <translation>الاسم طويل جدًّا؛ الصواب ⁨%1⁩ حرفًا على الأكثر</translation>
    </message>
    <message>
        <source>a name without \ : * ? &quot; &lt; &gt; | and without control characters is right</source>
        <translation>الصواب اسم خالٍ من ⁦\ : * ? &quot; &lt; &gt; |⁩ ومن أحرف التحكم</translation>
    </message>
    <message>
        <source>%1 names a device on some systems; another name is right</source>
        <translation>يسمّي ⁨%1⁩ جهازًا في بعض الأنظمة؛ الصواب اسم آخر</translation>
    </message>
    <message>
        <source>a name that ends with a letter or a digit is right</source>
        <translation>الصواب اسم ينتهي بحرف أو رقم</translation>
    </message>
    <message>
        <source>cannot be read: there is no such folder</source>
        <translation>تتعذر قراءته: لا يوجد مجلد كهذا</translation>
    </message>
    <message>
        <source>cannot be read: the folder may not be opened</source>
        <translation>تتعذر قراءته: لا يجوز فتح المجلد</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>تتعذر قراءته: لا يوجد ملف كهذا</translation>
    </message>
    <message>
        <source>a link here leads out of the lab; a file or folder of its own is right</source>
        <translation>وصلة هنا تقود إلى خارج المختبر؛ الصواب ملف أو مجلد خاص به</translation>
    </message>
    <message>
        <source>another file has this name but for capital letters; a name of its own is right</source>
        <translation>لملف آخر هذا الاسم مع اختلاف الأحرف الكبيرة فقط؛ الصواب اسم خاص به</translation>
    </message>
    <message>
        <source>another program changed %1 since the lab was read</source>
        <translation>غيّر برنامج آخر ⁨%1⁩ منذ قراءة المختبر</translation>
    </message>
    <message>
        <source>the picture has %1 × %2 pixels; at most %3 million are right</source>
        <translation>في الصورة ⁦%1 × %2⁩ بكسل؛ الصواب ⁨%3⁩ مليون على الأكثر</translation>
    </message>
</context>
<context>
    <name>LabMenu</name>
    <message>
        <source>&amp;Labs</source>
        <translation>المختبرات (&amp;L)</translation>
    </message>
</context>
<context>
    <name>LabReader</name>
    <message>
        <source>still the text of the template: %1</source>
        <translation>لا يزال نص القالب: ⁨%1⁩</translation>
    </message>
    <message>
        <source>not in this language yet: %1</source>
        <translation>ليس بهذه اللغة بعد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>the program is there whole, too; one of the two files is right</source>
        <translation>البرنامج موجود كاملًا أيضًا؛ الصواب أحد الملفين</translation>
    </message>
    <message>
        <source>the program begins without a comment; what the student should read of it stands there</source>
        <translation>يبدأ البرنامج بلا تعليق برمجي؛ وهناك يرد ما ينبغي أن يقرأه الطالب عنه</translation>
    </message>
    <message>
        <source>another step has the id %1 already; an id of its own is right</source>
        <translation>لمرحلة أخرى المعرّف ⁨%1⁩ بالفعل؛ الصواب معرّف خاص بها</translation>
    </message>
    <message>
        <source>the step %1 is listed already; each step once is right</source>
        <translation>المرحلة ⁨%1⁩ واردة بالفعل؛ الصواب كل مرحلة مرة واحدة</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>الملف كبير جدًّا؛ الصواب ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>تتعذر قراءته: لا يوجد ملف كهذا</translation>
    </message>
    <message>
        <source>the text is not in UTF-8, which would be right; some letters are lost</source>
        <translation>النص ليس بترميز ⁦UTF-8⁩، وهو الصواب؛ ضاعت بعض الأحرف</translation>
    </message>
    <message>
        <source>the text has characters that are none (NUL); a text in UTF-8 is right</source>
        <translation>في النص محارف ليست محارف ⁦(NUL)⁩؛ الصواب نص بترميز ⁦UTF-8⁩</translation>
    </message>
    <message>
        <source>a number from 1 to %1, for there are so many answers, is right</source>
        <translation>الصواب عدد من 1 إلى ⁨%1⁩، فهذا عدد الإجابات</translation>
    </message>
    <message>
        <source>%1 answers, as many as the task.json has, are right, not %2; the question is shown untranslated</source>
        <translation>الصواب عدد إجابات ⁦task.json⁩ نفسه، أي ⁨%1⁩، لا ⁨%2⁩؛ يُعرض السؤال دون ترجمة</translation>
    </message>
    <message>
        <source>a name of letters, digits and underscores that means nothing else is right</source>
        <translation>الصواب اسم من أحرف لاتينية وأرقام وشرطات سفلية لا يعني شيئًا آخر</translation>
    </message>
    <message>
        <source>a range from the least to the most, with a step that is greater than 0, is right</source>
        <translation>الصواب مجال من الأدنى إلى الأقصى بخطوة أكبر من 0</translation>
    </message>
    <message>
        <source>of what the step has not: %1</source>
        <translation>لما ليس في المرحلة: ⁨%1⁩</translation>
    </message>
    <message>
        <source>not in this language yet: the starter&apos;s comments</source>
        <translation>ليست بهذه اللغة بعد: تعليقات برنامج البداية</translation>
    </message>
    <message>
        <source>its code is not that of starter.lua; a starter in another language differs in comments alone</source>
        <translation>شيفرته ليست شيفرة ⁦starter.lua⁩؛ لا يختلف برنامج البداية بلغة أخرى إلا في التعليقات</translation>
    </message>
    <message>
        <source>there is no picture %1 in the step&apos;s folder</source>
        <translation>لا توجد صورة ⁨%1⁩ في مجلد المرحلة</translation>
    </message>
    <message>
        <source>&lt;!-- %1 --&gt; begins no part; explore, code and all do</source>
        <translation>⁦&lt;!-- %1 --&gt;⁩ لا يبدأ جزءًا؛ بل explore وcode وall</translation>
    </message>
</context>
<context>
    <name>LabReport</name>
    <message>
        <source>The scene at %1 s</source>
        <translation>المشهد عند ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>Checks: %1</source>
        <translation>مرات الفحص: ⁨%1⁩</translation>
    </message>
    <message>
        <source>You have written a physics engine</source>
        <translation>لقد كتبت محرّك فيزياء</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass, judged anew a moment ago.</source>
        <translation>المراحل المجتازة: ⁨%1⁩ من ⁨%2⁩، وحُكم عليها من جديد قبل لحظة.</translation>
    </message>
    <message>
        <source>What took the most checks</source>
        <translation>ما احتاج إلى أكثر مرات الفحص</translation>
    </message>
    <message>
        <source>The energy of all runs</source>
        <translation>طاقة كل التشغيلات</translation>
    </message>
    <message>
        <source>At %1 s, when two circles first meet</source>
        <translation>عند ⁦%1 s⁩، حين تلتقي دائرتان أول مرة</translation>
    </message>
    <message>
        <source>At %1 s, when a circle first reaches a wall</source>
        <translation>عند ⁦%1 s⁩، حين تبلغ دائرة جدارًا أول مرة</translation>
    </message>
    <message>
        <source>At %1 s</source>
        <translation>عند ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>غير متأكد</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass. Every step was judged anew for this report, by version %3 of the lab.</source>
        <translation>المراحل المجتازة: ⁨%1⁩ من ⁨%2⁩. حُكم على كل مرحلة من جديد لهذا التقرير، بالنسخة ⁨%3⁩ من المختبر.</translation>
    </message>
    <message>
        <source>To the teacher</source>
        <translation>إلى المدرّس</translation>
    </message>
    <message>
        <source>✓ passes</source>
        <translation>✓ تُجتاز</translation>
    </message>
    <message>
        <source>does not pass yet</source>
        <translation>لا تُجتاز بعد</translation>
    </message>
    <message>
        <source>stops with an error</source>
        <translation>تتوقف بخطأ</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>لم تُنجز</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>ملاحظات</translation>
    </message>
    <message>
        <source>Found on the way</source>
        <translation>ما تبيّن في الطريق</translation>
    </message>
    <message>
        <source>Expected and found</source>
        <translation>المتوقَّع والموجود</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>المتوقَّع: ⁨%1⁩</translation>
    </message>
    <message>
        <source>The run</source>
        <translation>التشغيل</translation>
    </message>
    <message>
        <source>What changed in the program</source>
        <translation>ما تغيّر في البرنامج</translation>
    </message>
    <message>
        <source>Nothing: it is the program of the step before.</source>
        <translation>لا شيء: هو برنامج المرحلة السابقة.</translation>
    </message>
    <message>
        <source>… and more, which no page holds.</source>
        <translation>… والمزيد، مما لا تسعه صفحة.</translation>
    </message>
    <message>
        <source>Looking back</source>
        <translation>نظرة إلى الوراء</translation>
    </message>
    <message>
        <source>The energy of the runs above in one chart, each as a part of what it started with. A law that keeps energy draws a straight line at 1; what lies above was made by the program, what lies below was lost.</source>
        <translation>طاقة التشغيلات أعلاه في مخطط واحد، كلٌّ منها كجزء مما بدأ به. القانون الذي يحفظ الطاقة يرسم خطًّا مستقيمًا عند 1؛ وما فوقه صنعه البرنامج، وما تحته فُقد.</translation>
    </message>
    <message>
        <source>Momentum of all circles, kg m/s</source>
        <translation>⁧كمية حركة كل الدوائر، ⁦kg m/s⁩⁩</translation>
    </message>
    <message>
        <source>Energy of all circles, J</source>
        <translation>⁧طاقة كل الدوائر، J⁩</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>الحركية</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>الكامنة</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>المجموع</translation>
    </message>
    <message>
        <source>Energy as a part of that at the start</source>
        <translation>الطاقة كجزء مما كانت في البداية</translation>
    </message>
    <message>
        <source>What happens: %1</source>
        <translation>ما يحدث: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>LabSearch</name>
    <message>
        <source>this file is broken, so nothing can be replaced in it, and nothing was replaced elsewhere; mend it first</source>
        <translation>هذا الملف معطوب، فلا يمكن استبدال شيء فيه، ولم يُستبدل شيء في غيره؛ أصلحه أولًا</translation>
    </message>
</context>
<context>
    <name>LabVerifier</name>
    <message>
        <source>stops with an error at line %1: %2</source>
        <translation>يتوقف بخطأ في السطر ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>passes; a starter should fail by a check</source>
        <translation>يجتاز؛ ينبغي أن يخفق برنامج البداية في فحص</translation>
    </message>
    <message>
        <source>fails with seed %1 by %2</source>
        <translation>يخفق مع البذرة ⁨%1⁩ في ⁨%2⁩</translation>
    </message>
    <message>
        <source>passes; a mistake should fail by a check</source>
        <translation>يجتاز؛ ينبغي أن يخفق الخطأ في فحص</translation>
    </message>
    <message>
        <source>is not recognised</source>
        <translation>لا يُتعرَّف عليه</translation>
    </message>
    <message>
        <source>is taken for %1</source>
        <translation>يُشخَّص على أنه ⁨%1⁩</translation>
    </message>
    <message>
        <source>fails by %1; work that gets a remark passes</source>
        <translation>يخفق في ⁨%1⁩؛ والعمل الذي ينال تعقيبًا يجتاز</translation>
    </message>
    <message>
        <source>the check %1 asks for the same as %2</source>
        <translation>الفحص ⁨%1⁩ يطلب ما يطلبه ⁨%2⁩</translation>
    </message>
    <message>
        <source>no mistake fails by the check %1 alone: it repeats %2</source>
        <translation>لا خطأ يخفق في الفحص ⁨%1⁩ وحده: فهو يكرّر ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 differs in more than its mistake: it has “%2” where the solution has “%3”</source>
        <translation>يختلف ⁨%1⁩ في أكثر من خطئه: فيه «⁨%2⁩» حيث في الحل «⁨%3⁩»</translation>
    </message>
    <message>
        <source>there is no solution.lua</source>
        <translation>لا يوجد ⁦solution.lua⁩</translation>
    </message>
    <message>
        <source>no mistake fails the check %1</source>
        <translation>لا خطأ يخفق في الفحص ⁨%1⁩</translation>
    </message>
    <message>
        <source>the check %1 allows %2, and the solution itself is off by %3 (%4): other right programs may fail; at least %5 is right</source>
        <translation>يسمح الفحص ⁨%1⁩ بمقدار ⁨%2⁩، والحل نفسه يبعد ⁨%3⁩ (⁨%4⁩): قد تخفق برامج صحيحة أخرى؛ الصواب ⁨%5⁩ على الأقل</translation>
    </message>
    <message>
        <source>fails what is turned, too fast, adrift by</source>
        <translation>يرفض ما دار، أو زادت سرعته، أو حاد بمقدار</translation>
    </message>
    <message>
        <source>with %1 seeds</source>
        <translation>عدد البذور ⁨%1⁩</translation>
    </message>
    <message>
        <source>with the values of the student %1: %2</source>
        <translation>بقيم الطالب ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>is not judged by the check %1: %2</source>
        <translation>لا يحكم عليه الفحص ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1: %2 of %3 values, %4 to %5</source>
        <comment>of a range</comment>
        <translation>⁨%1⁩: القيم ⁨%2⁩ من ⁨%3⁩، من ⁨%4⁩ إلى ⁨%5⁩</translation>
    </message>
    <message>
        <source>the question %1 asks for %2, and its tolerance is 0: nobody answers it rightly</source>
        <translation>السؤال ⁨%1⁩ يطلب ⁨%2⁩ وتفاوته 0: لا أحد يجيب عنه إجابة صحيحة</translation>
    </message>
    <message>
        <source>in the language %1: %2</source>
        <translation>باللغة ⁨%1⁩: ⁨%2⁩</translation>
    </message>
</context>
<context>
    <name>LawNames</name>
    <message>
        <source>None</source>
        <comment>law for walls</comment>
        <translation>بلا</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>انعكاس</translation>
    </message>
    <message>
        <source>None</source>
        <comment>law for circles</comment>
        <translation>بلا</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>توقف</translation>
    </message>
    <message>
        <source>Swap velocities</source>
        <translation>تبادل السرعتين</translation>
    </message>
    <message>
        <source>Swap normal parts</source>
        <translation>تبادل المركّبتين الناظميتين</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>دفع</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>متقطع</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>متصل</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>دقيق</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>أويلر</translation>
    </message>
    <message>
        <source>Symplectic Euler</source>
        <translation>أويلر التماثلية</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>فيرليه للسرعة</translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation>رونغه-كوتا 4</translation>
    </message>
    <message>
        <source>S. Euler</source>
        <comment>short for Symplectic Euler</comment>
        <translation>تماثلية</translation>
    </message>
    <message>
        <source>Verlet</source>
        <comment>short for Velocity Verlet</comment>
        <translation>فيرليه</translation>
    </message>
</context>
<context>
    <name>Lists</name>
    <message>
        <source>, </source>
        <extracomment>between the things of a list</extracomment>
        <translation>، </translation>
    </message>
</context>
<context>
    <name>Locks</name>
    <message>
        <source>gravity</source>
        <translation>الجاذبية</translation>
    </message>
    <message>
        <source>restitution</source>
        <translation>معامل الارتداد</translation>
    </message>
    <message>
        <source>timestep</source>
        <translation>الخطوة الزمنية</translation>
    </message>
    <message>
        <source>half width of the square</source>
        <translation>نصف عرض المربع</translation>
    </message>
    <message>
        <source>law for walls</source>
        <translation>قانون الجدران</translation>
    </message>
    <message>
        <source>law for circles</source>
        <translation>قانون الدوائر</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>التوقيت</translation>
    </message>
    <message>
        <source>number of circles</source>
        <translation>عدد الدوائر</translation>
    </message>
    <message>
        <source>position of %1</source>
        <translation>موضع ⁨%1⁩</translation>
    </message>
    <message>
        <source>velocity of %1</source>
        <translation>سرعة ⁨%1⁩</translation>
    </message>
    <message>
        <source>radius of %1</source>
        <translation>نصف قطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>density of %1</source>
        <translation>كثافة ⁨%1⁩</translation>
    </message>
    <message>
        <source>integrator of %1</source>
        <translation>طريقة تكامل ⁨%1⁩</translation>
    </message>
    <message>
        <source>mass of %1</source>
        <translation>كتلة ⁨%1⁩</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>الدائرة %1</translation>
    </message>
    <message>
        <source>Fixed in this step: %1</source>
        <translation>ثابت في هذه المرحلة: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>Loupe</name>
    <message>
        <source>%1×</source>
        <comment>magnification</comment>
        <translation>⁦%1×⁩</translation>
    </message>
</context>
<context>
    <name>LuaApi</name>
    <message>
        <source>You write it: runs once, before the first step</source>
        <translation>تكتبها أنت: تُنفَّذ مرة واحدة، قبل الخطوة الأولى</translation>
    </message>
    <message>
        <source>You write it: moves the circles by one step of timestep seconds</source>
        <translation>تكتبها أنت: تحرّك الدوائر خطوة واحدة مدتها timestep ثانية</translation>
    </message>
    <message>
        <source>A new vector; its unit is that of its numbers</source>
        <translation>متجه جديد؛ وحدته وحدة عدديه</translation>
    </message>
    <message>
        <source>The dot product of two vectors: a.x * b.x + a.y * b.y</source>
        <translation>الجداء السلّمي لمتجهين: ⁦a.x * b.x + a.y * b.y⁩</translation>
    </message>
    <message>
        <source>The first circle</source>
        <translation>الدائرة الأولى</translation>
    </message>
    <message>
        <source>The second circle</source>
        <translation>الدائرة الثانية</translation>
    </message>
    <message>
        <source>All circles: circles[1] to circles[#circles]</source>
        <translation>كل الدوائر: من ⁦circles[1]⁩ إلى ⁦circles[#circles]⁩</translation>
    </message>
    <message>
        <source>The acceleration of every circle, a vector in m/s²; may be set in on_load</source>
        <translation>تسارع كل دائرة، متجه بوحدة ⁦m/s²⁩؛ يجوز ضبطه في on_load</translation>
    </message>
    <message>
        <source>From 0 (no rebound) to 1 (elastic); may be set in on_load</source>
        <translation>من 0 (بلا ارتداد) إلى 1 (مرن)؛ يجوز ضبطه في on_load</translation>
    </message>
    <message>
        <source>The box that the circles are in</source>
        <translation>الصندوق الذي فيه الدوائر</translation>
    </message>
    <message>
        <source>Seconds since the start of the run, at the start of this step</source>
        <translation>الثواني منذ بداية التشغيل، عند بداية هذه الخطوة</translation>
    </message>
    <message>
        <source>The number of steps made so far</source>
        <translation>عدد الخطوات المنجزة حتى الآن</translation>
    </message>
    <message>
        <source>Adds a point of this step to the curve called name in the charts</source>
        <translation>يضيف نقطة من هذه الخطوة إلى المنحنى المسمّى name في المخططات</translation>
    </message>
    <message>
        <source>Draws over the scene, for this step</source>
        <translation>يرسم فوق المشهد، لهذه الخطوة</translation>
    </message>
    <message>
        <source>Writes a line to the console</source>
        <translation>يكتب سطرًا في وحدة الإخراج</translation>
    </message>
    <message>
        <source>Functions of numbers</source>
        <translation>دوال الأعداد</translation>
    </message>
    <message>
        <source>Functions of texts</source>
        <translation>دوال النصوص</translation>
    </message>
    <message>
        <source>Functions of lists</source>
        <translation>دوال القوائم</translation>
    </message>
    <message>
        <source>For a loop over a list in order: for i, v in ipairs(list) do</source>
        <translation>لحلقة على قائمة بالترتيب: ⁦for i, v in ipairs(list) do⁩</translation>
    </message>
    <message>
        <source>For a loop over all fields of a table: for k, v in pairs(t) do</source>
        <translation>لحلقة على كل حقول جدول: ⁦for k, v in pairs(t) do⁩</translation>
    </message>
    <message>
        <source>The arguments from number n on; with &apos;#&apos; how many there are</source>
        <translation>الوسائط من الرقم n فصاعدًا؛ ومع &apos;#&apos; عددها</translation>
    </message>
    <message>
        <source>What a value is, as a text: &quot;number&quot;, &quot;vector&quot;, &quot;circle&quot; …</source>
        <translation>ما نوع القيمة، نصًّا: ⁦&quot;number&quot;⁩، ⁦&quot;vector&quot;⁩، ⁦&quot;circle&quot;⁩ …</translation>
    </message>
    <message>
        <source>A value as a text</source>
        <translation>القيمة نصًّا</translation>
    </message>
    <message>
        <source>The number that a text says, or nil; base is 10 unless given</source>
        <translation>العدد الذي يقوله نص، أو nil؛ الأساس 10 ما لم يُعطَ</translation>
    </message>
    <message>
        <source>Stops the run with the message if value is false or nil</source>
        <translation>يوقف التشغيل بالرسالة إذا كانت القيمة false أو nil</translation>
    </message>
    <message>
        <source>Stops the run at this line with the message</source>
        <translation>يوقف التشغيل عند هذا السطر بالرسالة</translation>
    </message>
    <message>
        <source>Calls f: true and its results, or false and the error</source>
        <translation>يستدعي f ويعطي true ونتائجها، أو false والخطأ</translation>
    </message>
    <message>
        <source>The length of the vector</source>
        <translation>طول المتجه</translation>
    </message>
    <message>
        <source>The square of the length: v:dot(v)</source>
        <translation>مربع الطول: ⁦v:dot(v)⁩</translation>
    </message>
    <message>
        <source>The vector of length 1 with the same direction; an error for (0, 0)</source>
        <translation>المتجه الذي طوله 1 وله الاتجاه نفسه؛ خطأ عند ⁦(0, 0)⁩</translation>
    </message>
    <message>
        <source>The dot product with another vector</source>
        <translation>الجداء السلّمي مع متجه آخر</translation>
    </message>
    <message>
        <source>The vector turned left by 90°: (-y, x)</source>
        <translation>المتجه مُدارًا نحو اليسار ⁦90°⁩: ⁦(-y, x)⁩</translation>
    </message>
    <message>
        <source>The part to the right; to change it, build a new vector</source>
        <translation>المركّبة نحو اليمين؛ لتغييرها ابنِ متجهًا جديدًا</translation>
    </message>
    <message>
        <source>The part upwards; to change it, build a new vector</source>
        <translation>المركّبة نحو الأعلى؛ لتغييرها ابنِ متجهًا جديدًا</translation>
    </message>
    <message>
        <source>The centre, a vector in m</source>
        <translation>المركز، متجه بوحدة m</translation>
    </message>
    <message>
        <source>A vector in m/s</source>
        <translation>متجه بوحدة ⁦m/s⁩</translation>
    </message>
    <message>
        <source>In m, above 0</source>
        <translation>بوحدة m، أكبر من 0</translation>
    </message>
    <message>
        <source>In 1000 kg/m³, above 0: steel has 7.8</source>
        <translation>بوحدة ⁦1000 kg/m³⁩، أكبر من 0: للفولاذ 7.8</translation>
    </message>
    <message>
        <source>The number of the circle, from 1; cannot be set</source>
        <translation>رقم الدائرة، ابتداء من 1؛ لا يمكن ضبطه</translation>
    </message>
    <message>
        <source>Half the side of the box, in m</source>
        <translation>نصف ضلع الصندوق، بوحدة m</translation>
    </message>
    <message>
        <source>The x of the left wall, in m</source>
        <translation>الإحداثي x للجدار الأيسر، بوحدة m</translation>
    </message>
    <message>
        <source>The x of the right wall, in m</source>
        <translation>الإحداثي x للجدار الأيمن، بوحدة m</translation>
    </message>
    <message>
        <source>The y of the floor, in m</source>
        <translation>الإحداثي y للأرضية، بوحدة m</translation>
    </message>
    <message>
        <source>The y of the ceiling, in m</source>
        <translation>الإحداثي y للسقف، بوحدة m</translation>
    </message>
    <message>
        <source>An arrow that begins at from; colour and label may be left out</source>
        <translation>سهم يبدأ عند from؛ يجوز ترك اللون والتسمية</translation>
    </message>
    <message>
        <source>A line between two points; the colour may be left out</source>
        <translation>خط بين نقطتين؛ يجوز ترك اللون</translation>
    </message>
    <message>
        <source>A dot; the colour may be left out</source>
        <translation>نقطة؛ يجوز ترك اللون</translation>
    </message>
    <message>
        <source>A text at a point</source>
        <translation>نص عند نقطة</translation>
    </message>
    <message>
        <source>x without its sign</source>
        <translation>‏x بلا إشارته</translation>
    </message>
    <message>
        <source>The angle whose cosine is x, in radians</source>
        <translation>الزاوية التي جيب تمامها x، بالراديان</translation>
    </message>
    <message>
        <source>The angle whose sine is x, in radians</source>
        <translation>الزاوية التي جيبها x، بالراديان</translation>
    </message>
    <message>
        <source>The angle of the direction (x, y), in radians; x is 1 unless given</source>
        <translation>زاوية الاتجاه ⁦(x, y)⁩، بالراديان؛ x هو 1 ما لم يُعطَ</translation>
    </message>
    <message>
        <source>The next whole number that is not below x</source>
        <translation>أقرب عدد صحيح لا يقل عن x</translation>
    </message>
    <message>
        <source>The cosine of an angle in radians</source>
        <translation>جيب تمام زاوية بالراديان</translation>
    </message>
    <message>
        <source>Radians in degrees</source>
        <translation>الراديان بالدرجات</translation>
    </message>
    <message>
        <source>e to the power of x</source>
        <translation>‏e أُسّ x</translation>
    </message>
    <message>
        <source>The next whole number that is not above x</source>
        <translation>أقرب عدد صحيح لا يزيد على x</translation>
    </message>
    <message>
        <source>What is left of x divided by y, with the sign of x</source>
        <translation>باقي قسمة x على y، بإشارة x</translation>
    </message>
    <message>
        <source>Infinity: more than any number</source>
        <translation>لانهاية: أكبر من أي عدد</translation>
    </message>
    <message>
        <source>The logarithm of x; base is e unless given</source>
        <translation>لوغاريتم x؛ الأساس e ما لم يُعطَ</translation>
    </message>
    <message>
        <source>The largest of the numbers</source>
        <translation>أكبر الأعداد</translation>
    </message>
    <message>
        <source>The largest whole number of Lua</source>
        <translation>أكبر عدد صحيح في Lua</translation>
    </message>
    <message>
        <source>The smallest of the numbers</source>
        <translation>أصغر الأعداد</translation>
    </message>
    <message>
        <source>The smallest whole number of Lua</source>
        <translation>أصغر عدد صحيح في Lua</translation>
    </message>
    <message>
        <source>The whole part of x, and the rest</source>
        <translation>الجزء الصحيح من x، والباقي</translation>
    </message>
    <message>
        <source>3.14159…</source>
        <translation>3.14159…</translation>
    </message>
    <message>
        <source>Degrees in radians</source>
        <translation>الدرجات بالراديان</translation>
    </message>
    <message>
        <source>From 0 up to 1, or a whole number from m to n; the same in every run</source>
        <translation>من 0 إلى ما دون 1، أو عدد صحيح من m إلى n؛ واحد في كل تشغيل</translation>
    </message>
    <message>
        <source>Begins another row of random numbers</source>
        <translation>يبدأ سلسلة أخرى من الأعداد العشوائية</translation>
    </message>
    <message>
        <source>The sine of an angle in radians</source>
        <translation>جيب زاوية بالراديان</translation>
    </message>
    <message>
        <source>The square root of x</source>
        <translation>الجذر التربيعي لـ x</translation>
    </message>
    <message>
        <source>The tangent of an angle in radians</source>
        <translation>ظل زاوية بالراديان</translation>
    </message>
    <message>
        <source>x as a whole number, or nil if it is none</source>
        <translation>‏x عددًا صحيحًا، أو nil إن لم يكنه</translation>
    </message>
    <message>
        <source>&quot;integer&quot;, &quot;float&quot;, or nil if x is no number</source>
        <translation>⁦&quot;integer&quot;⁩ أو ⁦&quot;float&quot;⁩، أو nil إن لم يكن x عددًا</translation>
    </message>
    <message>
        <source>Whether m is below n, both read without sign</source>
        <translation>هل m أصغر من n، وكلاهما مقروء بلا إشارة</translation>
    </message>
    <message>
        <source>Values in a text: string.format(&quot;%.3f&quot;, x)</source>
        <translation>قيم في نص: ⁦string.format(&quot;%.3f&quot;, x)⁩</translation>
    </message>
    <message>
        <source>The number of bytes of a text</source>
        <translation>عدد بايتات النص</translation>
    </message>
    <message>
        <source>A text in small letters</source>
        <translation>النص بأحرف صغيرة</translation>
    </message>
    <message>
        <source>Part of a text; -1 is its last byte</source>
        <translation>جزء من نص؛ ⁦-1⁩ هو بايته الأخير</translation>
    </message>
    <message>
        <source>A text in capital letters</source>
        <translation>النص بأحرف كبيرة</translation>
    </message>
    <message>
        <source>The elements of a list as one text</source>
        <translation>عناصر قائمة نصًّا واحدًا</translation>
    </message>
    <message>
        <source>Puts a value into a list, at its end if no position is given</source>
        <translation>يضع قيمة في قائمة، في آخرها ما لم يُعطَ موضع</translation>
    </message>
    <message>
        <source>Takes an element out of a list, the last one unless told</source>
        <translation>يأخذ عنصرًا من قائمة، الأخير ما لم يُذكر غيره</translation>
    </message>
    <message>
        <source>Sorts a list; before(a, b) says whether a comes first</source>
        <translation>يرتّب قائمة؛ ⁦before(a, b)⁩ تقول هل يأتي a أولًا</translation>
    </message>
    <message>
        <source>The elements of a list as so many values</source>
        <translation>عناصر قائمة قيمًا بعددها</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>open this step</source>
        <translation>فتح هذه المرحلة</translation>
    </message>
    <message>
        <source>speak this language, such as en or de</source>
        <translation>استعمال هذه اللغة، مثل en أو ar</translation>
    </message>
    <message>
        <source>system, light, dark or high-contrast</source>
        <translation>‏system أو light أو dark أو ⁦high-contrast⁩</translation>
    </message>
    <message>
        <source>of texts, %: 100 to 200</source>
        <translation>حجم النصوص، %: من 100 إلى 200</translation>
    </message>
    <message>
        <source>open this scene of Lab → Example scenes</source>
        <translation>فتح هذا المشهد من المختبر ← مشاهد أمثلة</translation>
    </message>
    <message>
        <source>work on steps by this: explore or code</source>
        <translation>العمل على المراحل بهذا: explore أو code</translation>
    </message>
    <message>
        <source>take this program as your own of the step</source>
        <translation>أخذ هذا البرنامج برنامجًا لك في المرحلة</translation>
    </message>
    <message>
        <source>open this lab in the window in which labs are written</source>
        <translation>فتح هذا المختبر في النافذة التي تُكتب فيها المختبرات</translation>
    </message>
    <message>
        <source>of that window: scene, text, checks, programs or proof</source>
        <translation>تبويب تلك النافذة: scene أو text أو checks أو programs أو proof</translation>
    </message>
    <message>
        <source>draw the window into this file and quit</source>
        <translation>رسم النافذة في هذا الملف ثم الإنهاء</translation>
    </message>
    <message>
        <source>of the scene&apos;s time, s, in the picture</source>
        <translation>زمن المشهد، s، في الصورة</translation>
    </message>
    <message>
        <source>of the window, pixels</source>
        <translation>حجم النافذة، بكسل</translation>
    </message>
    <message>
        <source>Learn how a physics engine works by writing one.</source>
        <translation>تعلّم كيف يعمل محرّك الفيزياء بأن تكتب واحدًا.</translation>
    </message>
    <message>
        <source>the lab or the scene to open; without it Lab 4.2</source>
        <translation>المختبر أو المشهد المراد فتحه؛ ومن دونه المختبر 4.2</translation>
    </message>
    <message>
        <source>cradle: unexpected argument %1; one lab or scene is right</source>
        <translation>‏cradle: وسيط غير متوقع ⁨%1⁩؛ الصواب مختبر واحد أو مشهد واحد</translation>
    </message>
    <message>
        <source>cradle: --language %1: one of %2 is right</source>
        <translation>⁦cradle: --language %1⁩: الصواب واحدة من ⁨%2⁩</translation>
    </message>
    <message>
        <source>cradle: --theme %1: system, light, dark or high-contrast is right</source>
        <translation>⁦cradle: --theme %1⁩: الصواب system أو light أو dark أو ⁦high-contrast⁩</translation>
    </message>
    <message>
        <source>cradle: --mode %1: explore or code is right</source>
        <translation>⁦cradle: --mode %1⁩: الصواب explore أو code</translation>
    </message>
    <message>
        <source>cradle: --text-size %1: a number from 100 to 200 is right</source>
        <translation>⁦cradle: --text-size %1⁩: الصواب عدد من 100 إلى 200</translation>
    </message>
    <message>
        <source>there is no step %1; there are %2</source>
        <translation>لا توجد مرحلة ⁨%1⁩؛ المراحل ⁨%2⁩</translation>
    </message>
    <message>
        <source>there is no step %1 in this lab</source>
        <translation>لا توجد مرحلة ⁨%1⁩ في هذا المختبر</translation>
    </message>
    <message>
        <source>there is no example %1; there are %2</source>
        <translation>لا يوجد مثال ⁨%1⁩؛ الأمثلة ⁨%2⁩</translation>
    </message>
    <message>
        <source>--tab %1: scene, text, checks, programs or proof is right</source>
        <translation>⁦--tab %1⁩: الصواب scene أو text أو checks أو programs أو proof</translation>
    </message>
    <message>
        <source>--at %1: a number of seconds from 0 to %2 is right</source>
        <translation>⁦--at %1⁩: الصواب عدد من الثواني من 0 إلى ⁨%2⁩</translation>
    </message>
    <message>
        <source>--size %1: a size like 1280x800 is right</source>
        <translation>⁦--size %1⁩: الصواب حجم مثل ⁦1280x800⁩</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>تتعذر كتابة ⁨%1⁩: ⁨%2⁩</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;States of the run as CSV…</source>
        <translation>حالات التشغيل بصيغة CSV (&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Totals of the run as CSV…</source>
        <translation>مجاميع التشغيل بصيغة CSV (&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Hits of the run as CSV…</source>
        <translation>تصادمات التشغيل بصيغة CSV (&amp;H)…</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>تصدير (&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Example scenes</source>
        <translation>مشاهد أمثلة (&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Lab</source>
        <translation>المختبر (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>المرحلة التالية (&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>المرحلة السابقة (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>التقرير (&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>التسليم (&amp;H)…</translation>
    </message>
    <message>
        <source>Share with &amp;git…</source>
        <translation>المشاركة بـ git (&amp;G)…</translation>
    </message>
    <message>
        <source>Grade a &amp;class…</source>
        <translation>تقييم صف (&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Open lab…</source>
        <translation>فتح مختبر (&amp;O)…</translation>
    </message>
    <message>
        <source>Open lab in one &amp;file…</source>
        <translation>فتح مختبر في ملف واحد (&amp;F)…</translation>
    </message>
    <message>
        <source>Open &amp;scene…</source>
        <translation>فتح مشهد (&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Author a lab…</source>
        <translation>تأليف مختبر (&amp;A)…</translation>
    </message>
    <message>
        <source>Sa&amp;ve scene as…</source>
        <translation>حفظ المشهد باسم (&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>إنهاء (&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>تحرير (&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Add circle</source>
        <translation>إضافة دائرة (&amp;N)</translation>
    </message>
    <message>
        <source>Reset to the &amp;step&apos;s scene</source>
        <translation>العودة إلى مشهد المرحلة (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Pin this run</source>
        <translation>تثبيت هذا التشغيل (&amp;P)</translation>
    </message>
    <message>
        <source>Keeps its curves, pale, beneath those of later runs</source>
        <translation>يُبقي منحنياته باهتةً تحت منحنيات التشغيلات اللاحقة</translation>
    </message>
    <message>
        <source>Remo&amp;ve pinned runs</source>
        <translation>إزالة التشغيلات المثبّتة (&amp;V)</translation>
    </message>
    <message>
        <source>Start a &amp;new run from here</source>
        <translation>بدء تشغيل جديد من هنا (&amp;N)</translation>
    </message>
    <message>
        <source>The moment shown becomes the start of the scene; the run so far stays in the charts</source>
        <translation>تصير اللحظة المعروضة بداية المشهد؛ ويبقى التشغيل السابق في المخططات</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>المحاكاة (&amp;S)</translation>
    </message>
    <message>
        <source>Pause at &amp;hits</source>
        <translation>إيقاف مؤقت عند التصادمات (&amp;H)</translation>
    </message>
    <message>
        <source>A run stops at the step of every collision; Run goes on</source>
        <translation>يتوقف التشغيل عند خطوة كل تصادم؛ و«تشغيل» يواصل</translation>
    </message>
    <message>
        <source>Slow &amp;motion around hits</source>
        <translation>حركة بطيئة حول التصادمات (&amp;M)</translation>
    </message>
    <message>
        <source>A run goes at 1/8× after every hit, and before those that are recorded already; its steps stay as they are</source>
        <translation>يسير التشغيل بسرعة ⁦1/8×⁩ بعد كل تصادم، وقبل التصادمات المسجّلة بالفعل؛ وتبقى خطواته كما هي</translation>
    </message>
    <message>
        <source>Steps as long as the &amp;frames took</source>
        <translation>خطوات مدتها مدة الإطارات (&amp;F)</translation>
    </message>
    <message>
        <source>As the original lab did: see why stable timesteps matter</source>
        <translation>كما كان المختبر الأصلي يفعل: انظر لماذا تهم الخطوات الزمنية الثابتة</translation>
    </message>
    <message>
        <source>&amp;Scene shows</source>
        <translation>ما يعرضه المشهد (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>السرعات (&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>الآثار (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Parts of a hit</source>
        <translation>مركّبات التصادم (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Loupe at a hit</source>
        <translation>عدسة مكبّرة عند التصادم (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Momenta tip to tail</source>
        <translation>كميات الحركة رأسًا إلى ذيل (&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Centre of mass and its way</source>
        <translation>مركز الكتلة ومساره (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Drawings of the program</source>
        <translation>رسوم البرنامج (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>الأسماء (&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>الشبكة (&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Exact motion beside the run</source>
        <translation>الحركة الدقيقة إلى جانب التشغيل (&amp;E)</translation>
    </message>
    <message>
        <source>Outlines where every circle would be without any error of the integrator, the program or the timestep</source>
        <translation>محيطات حيث كانت كل دائرة ستكون بلا أي خطأ من طريقة التكامل أو البرنامج أو الخطوة الزمنية</translation>
    </message>
    <message>
        <source>&amp;Follow the centre of mass</source>
        <translation>متابعة مركز الكتلة (&amp;L)</translation>
    </message>
    <message>
        <source>The view moves along with it: in its frame the momenta of all circles add up to nothing</source>
        <translation>تتحرك الرؤية معه: في إطاره المرجعي مجموع كميات حركة كل الدوائر صفر</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>تكبير (&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>تصغير (&amp;O)</translation>
    </message>
    <message>
        <source>Zoom to the hi&amp;t</source>
        <translation>تكبير التصادم (&amp;M)</translation>
    </message>
    <message>
        <source>Show the whole s&amp;quare</source>
        <translation>عرض المربع كله (&amp;W)</translation>
    </message>
    <message>
        <source>C&amp;harts</source>
        <translation>المخططات (&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Reset zoom</source>
        <translation>إعادة التكبير الأصلي (&amp;R)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>عرض (&amp;V)</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>ملء الشاشة (&amp;F)</translation>
    </message>
    <message>
        <source>Scene &amp;alone</source>
        <translation>المشهد وحده (&amp;A)</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>عرض تقديمي (&amp;T)</translation>
    </message>
    <message>
        <source>Large texts and high contrast; Page Up and Page Down go from hit to hit, B makes it black, Esc ends it</source>
        <translation>نصوص كبيرة وتباين عالٍ؛ ⁦Page Up⁩ و⁦Page Down⁩ ينتقلان من تصادم إلى تصادم، وB يسوّد الشاشة، وEsc ينهيه</translation>
    </message>
    <message>
        <source>Scene in a &amp;window of its own</source>
        <translation>المشهد في نافذة مستقلة (&amp;D)</translation>
    </message>
    <message>
        <source>Hits to scree&amp;n readers</source>
        <translation>التصادمات لقارئات الشاشة (&amp;N)</translation>
    </message>
    <message>
        <source>They tell every hit that is shown; of a run that goes on, one in a while</source>
        <translation>تخبر بكل تصادم يُعرض؛ وفي تشغيل جارٍ، بواحد بين حين وآخر</translation>
    </message>
    <message>
        <source>Ne&amp;xt pane</source>
        <translation>اللوحة التالية (&amp;X)</translation>
    </message>
    <message>
        <source>Pre&amp;vious pane</source>
        <translation>اللوحة السابقة (&amp;V)</translation>
    </message>
    <message>
        <source>Into the progra&amp;m</source>
        <translation>إلى داخل البرنامج (&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Panes</source>
        <translation>اللوحات (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Move panes</source>
        <translation>نقل اللوحات (&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>إعادة التخطيط الأصلي (&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>الألوان (&amp;C)</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>كما في النظام (&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>فاتح (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>داكن (&amp;D)</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>تباين عالٍ (&amp;H)</translation>
    </message>
    <message>
        <source>Si&amp;ze of texts</source>
        <translation>حجم النصوص (&amp;Z)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>⁦%1 %⁩</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>اللغة (&amp;G)</translation>
    </message>
    <message>
        <source>Scene drawn &amp;by</source>
        <translation>رسم المشهد بواسطة (&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>تلقائي (&amp;A)</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>OpenGL (&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Processor</source>
        <translation>المعالج (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>مساعدة (&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Reference of the lab&apos;s Lua</source>
        <translation>مرجع لغة Lua في المختبر (&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Lua for C# people</source>
        <translation>‏Lua لمن يعرف ⁦C#⁩ (&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>جولة في النافذة (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>اختصارات لوحة المفاتيح (&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Cradle</source>
        <translation>حول Cradle (&amp;A)</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>حول Qt (&amp;Q)</translation>
    </message>
    <message>
        <source>S&amp;ounds of hits</source>
        <translation>أصوات التصادمات (&amp;O)</translation>
    </message>
    <message>
        <source>The heavier a circle, the lower its tone; the greater the impulse, the louder</source>
        <translation>كلما كانت الدائرة أثقل كانت نغمتها أغلظ؛ وكلما كبر الدفع علا الصوت</translation>
    </message>
</context>
<context>
    <name>MomentumInset</name>
    <message>
        <source>Momentum</source>
        <translation>كمية الحركة</translation>
    </message>
    <message>
        <source>%1 kg m/s</source>
        <translation>⁦%1 kg m/s⁩</translation>
    </message>
</context>
<context>
    <name>Mutations</name>
    <message>
        <source>A term has the wrong sign</source>
        <translation>لأحد الحدود إشارة خاطئة</translation>
    </message>
    <message>
        <source>Which way should this term act? Try it with a circle that moves to the right.</source>
        <translation>في أي جهة ينبغي أن يؤثر هذا الحد؟ جرّبه بدائرة تتحرك نحو اليمين.</translation>
    </message>
    <message>
        <source>The factor `%1` is missing</source>
        <translation>العامل ⁦`%1`⁩ ناقص</translation>
    </message>
    <message>
        <source>Do both sides have the same unit? What changes if this factor is twice as large?</source>
        <translation>هل للطرفين الوحدة نفسها؟ ماذا يتغير إن تضاعف هذا العامل؟</translation>
    </message>
    <message>
        <source>Something stands in the wrong place</source>
        <translation>شيء ما في موضع خاطئ</translation>
    </message>
    <message>
        <source>A product comes before a sum: what belongs together here?</source>
        <translation>الضرب قبل الجمع: ما الذي ينتمي بعضه إلى بعض هنا؟</translation>
    </message>
    <message>
        <source>The normal does not have the length 1</source>
        <translation>طول الناظم ليس 1</translation>
    </message>
    <message>
        <source>How long is this vector? A part along it is right only if its length is 1.</source>
        <translation>ما طول هذا المتجه؟ المركّبة على امتداده صحيحة فقط إذا كان طوله 1.</translation>
    </message>
    <message>
        <source>A comparison is the wrong way round</source>
        <translation>مقارنة معكوسة</translation>
    </message>
    <message>
        <source>When should this happen: above or below?</source>
        <translation>متى ينبغي أن يحدث هذا: فوق أم تحت؟</translation>
    </message>
    <message>
        <source>A part of a condition is missing</source>
        <translation>ينقص جزء من شرط</translation>
    </message>
    <message>
        <source>When should this happen, and when not? Think of circles that already move apart, and of every wall.</source>
        <translation>متى ينبغي أن يحدث هذا ومتى لا؟ فكّر في دائرتين تتباعدان بالفعل، وفي كل جدار.</translation>
    </message>
    <message>
        <source>One case is missing</source>
        <translation>تنقص حالة</translation>
    </message>
    <message>
        <source>Go through the cases one by one: which of them does nothing?</source>
        <translation>مرّ على الحالات واحدة واحدة: أيّها لا يفعل شيئًا؟</translation>
    </message>
    <message>
        <source>It happens always</source>
        <translation>يحدث دائمًا</translation>
    </message>
    <message>
        <source>When should this happen, and when not?</source>
        <translation>متى ينبغي أن يحدث هذا ومتى لا؟</translation>
    </message>
    <message>
        <source>`%1` stands where `%2` belongs</source>
        <translation>يرد ⁦`%1`⁩ حيث مكان ⁦`%2`⁩</translation>
    </message>
    <message>
        <source>Which circle, and which coordinate, is meant here?</source>
        <translation>أيّ دائرة، وأيّ إحداثي، هو المقصود هنا؟</translation>
    </message>
    <message>
        <source>The hit takes nothing</source>
        <translation>لا يأخذ التصادم شيئًا</translation>
    </message>
    <message>
        <source>Which part of the velocity should become e times what it was?</source>
        <translation>أيّ مركّبة من السرعة ينبغي أن تُضرب في e؟</translation>
    </message>
    <message>
        <source>e counts twice</source>
        <translation>يُحسب e مرتين</translation>
    </message>
    <message>
        <source>How fast does it leave, compared with how fast it came?</source>
        <translation>كم سرعة المغادرة مقارنةً بسرعة المجيء؟</translation>
    </message>
    <message>
        <source>Something is left out</source>
        <translation>تُرك شيء</translation>
    </message>
    <message>
        <source>Compare with the instructions what has to be done for every circle in every step.</source>
        <translation>قارن بالتعليمات: ماذا يجب أن يُفعل لكل دائرة في كل خطوة.</translation>
    </message>
    <message>
        <source>Something happens twice</source>
        <translation>شيء ما يحدث مرتين</translation>
    </message>
    <message>
        <source>How often does this run in one step?</source>
        <translation>كم مرة يُنفَّذ هذا في خطوة واحدة؟</translation>
    </message>
    <message>
        <source>Two lines stand in the other order</source>
        <translation>سطران بترتيب معكوس</translation>
    </message>
    <message>
        <source>Which value does the second line need: the one from before or the one from after the first?</source>
        <translation>أيّ قيمة يحتاج إليها السطر الثاني: التي قبل الأول أم التي بعده؟</translation>
    </message>
</context>
<context>
    <name>Panes</name>
    <message>
        <source>Step</source>
        <translation>المرحلة</translation>
    </message>
    <message>
        <source>lab.lua</source>
        <translation>lab.lua</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>الخصائص</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>النسخ</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>ملاحظات</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>كمية الحركة</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>الطاقة</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>القيم</translation>
    </message>
</context>
<context>
    <name>ParameterText</name>
    <message>
        <source>from %1 to %2%3</source>
        <translation>من ⁨%1⁩ إلى ⁨%2⁩⁨%3⁩</translation>
    </message>
    <message>
        <source>%1%2 or more</source>
        <translation>⁨%1⁩⁨%2⁩ أو أكثر</translation>
    </message>
    <message>
        <source>any%1</source>
        <translation>أي قيمة⁨%1⁩</translation>
    </message>
    <message>
        <source>%1: a whole number, %2, is right</source>
        <translation>⁨%1⁩: الصواب عدد صحيح، ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1: two numbers as “2, 0”, %2, are right</source>
        <translation>⁨%1⁩: الصواب عددان مثل «⁦2, 0⁩»، ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1: the least and the most as “0.5, 2”, %2, are right</source>
        <translation>⁨%1⁩: الصواب الأدنى والأقصى مثل «⁦0.5, 2⁩»، ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1: pairs of numbers as “2, 0; 0, 0”, %2, are right</source>
        <translation>⁨%1⁩: الصواب أزواج أعداد مثل «⁦2, 0; 0, 0⁩»، ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1: numbers as “0.5, 1”, %2, are right</source>
        <translation>⁨%1⁩: الصواب أعداد مثل «⁦0.5, 1⁩»، ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1: a number, %2, is right</source>
        <translation>⁨%1⁩: الصواب عدد، ⁨%2⁩</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>نعم</translation>
    </message>
    <message>
        <source>no</source>
        <translation>لا</translation>
    </message>
    <message>
        <source>, in %1</source>
        <translation>، بوحدة ⁦%1⁩</translation>
    </message>
</context>
<context>
    <name>Phase</name>
    <message>
        <source>kinetic</source>
        <translation>الحركية</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>الكامنة</translation>
    </message>
    <message>
        <source>total</source>
        <translation>الكلية</translation>
    </message>
    <message>
        <source>distance 1–2</source>
        <translation>المسافة ⁦1–2⁩</translation>
    </message>
    <message>
        <source>off exact</source>
        <translation>البعد عن الدقيقة</translation>
    </message>
    <message>
        <source>more than exact</source>
        <translation>الزيادة على الدقيقة</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>الزمن</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>الموضع x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>الموضع y</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>السرعة نحو اليمين</translation>
    </message>
    <message>
        <source>Velocity upwards</source>
        <translation>السرعة نحو الأعلى</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>مقدار السرعة</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>كمية الحركة نحو اليمين</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>كمية الحركة نحو الأعلى</translation>
    </message>
    <message>
        <source>Size of the momentum</source>
        <translation>مقدار كمية الحركة</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>الطاقة الحركية</translation>
    </message>
    <message>
        <source>Potential energy</source>
        <translation>الطاقة الكامنة</translation>
    </message>
    <message>
        <source>Total energy</source>
        <translation>الطاقة الكلية</translation>
    </message>
    <message>
        <source>Distance of circles 1 and 2</source>
        <translation>المسافة بين الدائرتين 1 و2</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>البعد عن الحركة الدقيقة</translation>
    </message>
    <message>
        <source>Energy more than the exact motion</source>
        <translation>الطاقة زيادةً على الحركة الدقيقة</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
    <message>
        <source>m</source>
        <comment>metres</comment>
        <translation>m</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>J</source>
        <comment>joules</comment>
        <translation>J</translation>
    </message>
    <message>
        <source>%1 all</source>
        <comment>quantity, of all circles</comment>
        <translation>⁨%1⁩ للكل</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>%1 circles of radius %2 m do not fit into the square; at most %3 are right</source>
        <translation>دوائر عددها ⁨%1⁩ ونصف قطرها ⁦%2 m⁩ لا يسعها المربع؛ الصواب ⁨%3⁩ على الأكثر</translation>
    </message>
    <message>
        <source>%1 is out of range; a number from %2 to %3 is right</source>
        <translation>⁨%1⁩ خارج المجال؛ الصواب عدد من ⁨%2⁩ إلى ⁨%3⁩</translation>
    </message>
    <message>
        <source>the name is too long; at most %1 characters are right</source>
        <translation>الاسم طويل جدًّا؛ الصواب ⁨%1⁩ حرفًا على الأكثر</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; one like #1e90ff is right</source>
        <translation>&quot;⁨%1⁩&quot; ليس لونًا؛ الصواب لون مثل ⁦#1e90ff⁩</translation>
    </message>
    <message>
        <source>it is wider than the square</source>
        <translation>إنها أعرض من المربع</translation>
    </message>
    <message>
        <source>x and y from %1 to %2 m are right</source>
        <translation>الصواب x وy من ⁨%1⁩ إلى ⁦%2 m⁩</translation>
    </message>
    <message>
        <source>circle %1 at (%2, %3) m is not inside the square, whose walls reflect; %4</source>
        <translation>الدائرة ⁨%1⁩ في ⁦(%2, %3) m⁩ ليست داخل المربع الذي تعكس جدرانه؛ ⁨%4⁩</translation>
    </message>
    <message>
        <source>circles %1 and %2 overlap: their centres are %3 m apart; at least r₁ + r₂ = %4 m is right</source>
        <translation>الدائرتان ⁨%1⁩ و⁨%2⁩ متداخلتان: المسافة بين مركزيهما ⁦%3 m⁩؛ الصواب ⁦r₁ + r₂ = %4 m⁩ على الأقل</translation>
    </message>
    <message>
        <source>at most %1 circles are right</source>
        <translation>الصواب ⁨%1⁩ دائرة على الأكثر</translation>
    </message>
</context>
<context>
    <name>Progress</name>
    <message>
        <source>your progress could not be saved: %1</source>
        <translation>تعذّر حفظ تقدّمك: ⁨%1⁩</translation>
    </message>
    <message>
        <source>your progress could not be read (%2) and was moved to %1; Cradle begins anew</source>
        <translation>تعذّرت قراءة تقدّمك (⁨%2⁩) ونُقل إلى ⁨%1⁩؛ يبدأ Cradle من جديد</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message>
        <source>“%1” is no number; one like 0.75 is asked for</source>
        <translation>«⁨%1⁩» ليس عددًا؛ المطلوب عدد مثل 0.75</translation>
    </message>
    <message>
        <source>“%1” is no number with a unit; one like 3.2 kg is asked for</source>
        <translation>«⁨%1⁩» ليس عددًا مع وحدة؛ المطلوب مثل ⁦3.2 kg⁩</translation>
    </message>
    <message>
        <source>“%1” is no unit that is known</source>
        <translation>«⁨%1⁩» ليست وحدة معروفة</translation>
    </message>
    <message>
        <source>the number is right; its unit is missing</source>
        <translation>العدد صواب؛ وتنقص وحدته</translation>
    </message>
    <message>
        <source>%1 is not right, and its unit is missing</source>
        <translation>⁨%1⁩ ليس صوابًا، وتنقص وحدته</translation>
    </message>
    <message>
        <source>the number is right, but not its unit: what is asked for is not measured in %1</source>
        <translation>العدد صواب، لا وحدته: المطلوب لا يُقاس بوحدة ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 is not right: what is asked for is not measured in %2</source>
        <translation>⁨%1⁩ ليس صوابًا: المطلوب لا يُقاس بوحدة ⁨%2⁩</translation>
    </message>
    <message>
        <source>the number is right, but not in %1</source>
        <translation>العدد صواب، لكن ليس بوحدة ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 is not right</source>
        <translation>⁨%1⁩ ليس صوابًا</translation>
    </message>
    <message>
        <source>one that is chosen is not right, and a right one is missing</source>
        <translation>إحدى الإجابات المختارة خطأ، وتنقص إجابة صحيحة</translation>
    </message>
    <message>
        <source>one that is chosen is not right</source>
        <translation>إحدى الإجابات المختارة خطأ</translation>
    </message>
    <message>
        <source>all that is chosen is right, but not all that is right is chosen</source>
        <translation>كل ما اختير صحيح، لكن لم يُختر كل الصحيح</translation>
    </message>
    <message>
        <source>not all of them are in the order</source>
        <translation>ليست كلها في الترتيب</translation>
    </message>
    <message>
        <source>it does not begin with what is first</source>
        <translation>لا يبدأ بما هو أول</translation>
    </message>
    <message>
        <source>the order is right up to number %1, and not behind it</source>
        <translation>الترتيب صحيح حتى الرقم ⁨%1⁩، وليس بعده</translation>
    </message>
    <message>
        <source>the answer that is chosen is not right</source>
        <translation>الإجابة المختارة ليست صوابًا</translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation>لم يُجب عنه بعد</translation>
    </message>
    <message>
        <source>for the teacher to read, who may give up to %1 points: %2</source>
        <translation>يقرؤه المدرّس، وله أن يعطي من النقاط حتى ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>a list of two to eight answers is right</source>
        <translation>الصواب قائمة من إجابتين إلى ثماني إجابات</translation>
    </message>
    <message>
        <source>the right answers by their numbers from 1 are missing</source>
        <translation>تنقص الإجابات الصحيحة بأرقامها ابتداء من 1</translation>
    </message>
    <message>
        <source>a number from 1 to %1, for there are so many answers, is right</source>
        <translation>الصواب عدد من 1 إلى ⁨%1⁩، فهذا عدد الإجابات</translation>
    </message>
    <message>
        <source>one right answer; for more of them the kind is several</source>
        <translation>إجابة صحيحة واحدة؛ ولأكثر منها فالنوع several</translation>
    </message>
    <message>
        <source>%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right</source>
        <translation>⁨%1⁩ ليست وحدة؛ الصواب مثل ⁦m/s⁩ أو ⁦kg m/s⁩ أو ⁦N s⁩ أو J أو ° أو %</translation>
    </message>
    <message>
        <source>another check or question has the id %1 already; an id of its own is right</source>
        <translation>لفحص أو سؤال آخر المعرّف ⁨%1⁩ بالفعل؛ الصواب معرّف خاص به</translation>
    </message>
    <message>
        <source>the right number is missing</source>
        <translation>ينقص العدد المطلوب</translation>
    </message>
    <message>
        <source>Tolerance: a number from 0 is right</source>
        <translation>التفاوت المسموح: الصواب عدد ابتداء من 0</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>في الخطوة ⁨%1⁩، عند ⁦%2 s⁩</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>مع ⁨%1⁩</translation>
    </message>
    <message>
        <source>Look at %1:%2</source>
        <translation>انظر إلى ⁨%1⁩:⁨%2⁩</translation>
    </message>
    <message>
        <source>The program moved the circles.</source>
        <translation>البرنامج حرّك الدوائر.</translation>
    </message>
    <message>
        <source>The laws of the scene moved the circles.</source>
        <translation>قوانين المشهد حرّكت الدوائر.</translation>
    </message>
    <message>
        <source>Commit message: %1</source>
        <translation>رسالة الإيداع: ⁨%1⁩</translation>
    </message>
    <message>
        <source>in the scene: %1</source>
        <translation>في المشهد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>last assigned in that step by %1:%2</source>
        <translation>آخر إسناد في تلك الخطوة من ⁨%1⁩:⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 passed</source>
        <translation>اجتيزت ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 did not pass: the program stopped</source>
        <translation>لم تُجتز ⁨%1⁩: توقف البرنامج</translation>
    </message>
    <message>
        <source>%1 did not pass: the program stopped before its first step</source>
        <translation>لم تُجتز ⁨%1⁩: توقف البرنامج قبل خطوته الأولى</translation>
    </message>
    <message>
        <source>%1 did not pass: the program does not load</source>
        <translation>لم تُجتز ⁨%1⁩: البرنامج لا يُحمَّل</translation>
    </message>
    <message>
        <source>%1 did not pass: %2 of %3 checks and answers failed</source>
        <translation>لم تُجتز ⁨%1⁩: الفحوص والإجابات المخفقة ⁨%2⁩ من ⁨%3⁩</translation>
    </message>
    <message>
        <source>%1 did not pass: %2 of %3 checks failed</source>
        <translation>لم تُجتز ⁨%1⁩: الفحوص المخفقة ⁨%2⁩ من ⁨%3⁩</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 points)</source>
        <translation>⁨%1⁩ (النقاط: ⁨%2⁩ من ⁨%3⁩)</translation>
    </message>
</context>
<context>
    <name>ReportPrinter</name>
    <message>
        <source>%1 of %2</source>
        <translation>⁨%1⁩ من ⁨%2⁩</translation>
    </message>
</context>
<context>
    <name>ResultPane</name>
    <message>
        <source>%1: %2</source>
        <comment>place, message</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The program cannot be read</source>
        <translation>تتعذر قراءة البرنامج</translation>
    </message>
    <message>
        <source>The program takes too long</source>
        <translation>يستغرق البرنامج وقتًا أطول مما ينبغي</translation>
    </message>
    <message>
        <source>The program needs too much memory</source>
        <translation>يحتاج البرنامج إلى ذاكرة أكثر مما ينبغي</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>لم يُحكم عليه</translation>
    </message>
    <message>
        <source>The program stopped</source>
        <translation>توقف البرنامج</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>السطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>في الخطوة ⁨%1⁩، عند ⁦%2 s⁩</translation>
    </message>
</context>
<context>
    <name>RunDifference</name>
    <message>
        <source>circle %1</source>
        <translation>الدائرة %1</translation>
    </message>
    <message>
        <source>laws → program</source>
        <translation>القوانين ← البرنامج</translation>
    </message>
    <message>
        <source>program → laws</source>
        <translation>البرنامج ← القوانين</translation>
    </message>
    <message>
        <source>program changed</source>
        <translation>تغيّر البرنامج</translation>
    </message>
    <message>
        <source>half width</source>
        <translation>نصف العرض</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>التوقيت</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>الجدران</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>الدوائر</translation>
    </message>
    <message>
        <source>%1 → %2 circles</source>
        <translation>عدد الدوائر من ⁨%1⁩ إلى ⁨%2⁩</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>%1 m/s</source>
        <translation>⁦%1 m/s⁩</translation>
    </message>
</context>
<context>
    <name>SceneTemplates</name>
    <message>
        <source>Head-on collision</source>
        <translation>تصادم وجهًا لوجه</translation>
    </message>
    <message>
        <source>Glancing collision</source>
        <translation>تصادم مائل</translation>
    </message>
    <message>
        <source>Newton&apos;s cradle</source>
        <translation>مهد نيوتن</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>غاز</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>سقوط</translation>
    </message>
</context>
<context>
    <name>Schema</name>
    <message numerus="yes">
        <source>a list of %n value(s)</source>
        <translation>
            <numerusform>قائمة من %n قيم</numerusform>
            <numerusform>قائمة من قيمة واحدة</numerusform>
            <numerusform>قائمة من قيمتين</numerusform>
            <numerusform>قائمة من %n قيم</numerusform>
            <numerusform>قائمة من %n قيمة</numerusform>
            <numerusform>قائمة من %n قيمة</numerusform>
        </translation>
    </message>
    <message>
        <source>an object</source>
        <translation>كائن</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; the keys here are %2</source>
        <translation>مفتاح غير معروف &quot;⁨%1⁩&quot;؛ المفاتيح هنا ⁨%2⁩</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>&quot;⁨%1⁩&quot; ناقص</translation>
    </message>
    <message>
        <source>%1 is not right here; right would be %2</source>
        <translation>⁨%1⁩ ليس صوابًا هنا؛ الصواب ⁨%2⁩</translation>
    </message>
    <message>
        <source>needs a newer Cradle: format %1, this one reads %2</source>
        <translation>يحتاج إلى نسخة أحدث من Cradle: الصيغة ⁨%1⁩، وهذه تقرأ ⁨%2⁩</translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation>هذا ليس JSON: ⁨%1⁩</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>هذا مجلد؛ الصواب ملف</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>تتعذر قراءته: ⁨%1⁩</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>الملف كبير جدًّا؛ الصواب ⁨%1⁩ على الأكثر</translation>
    </message>
    <message>
        <source>a list of questions</source>
        <translation>قائمة أسئلة</translation>
    </message>
    <message>
        <source>a list of two to eight answers</source>
        <translation>قائمة من إجابتين إلى ثماني إجابات</translation>
    </message>
    <message>
        <source>a number or an expression, the number of an answer from 1, or a list of such numbers</source>
        <translation>عدد أو عبارة، أو رقم إجابة ابتداء من 1، أو قائمة من هذه الأرقام</translation>
    </message>
    <message>
        <source>a number, an expression like 2*k, or an object with from, to and step</source>
        <translation>عدد، أو عبارة مثل ⁦2*k⁩، أو كائن فيه from وto وstep</translation>
    </message>
    <message>
        <source>a text of 1 to 200 characters</source>
        <translation>نص من 1 إلى 200 حرف</translation>
    </message>
    <message>
        <source>a text of at most 200 characters; another draws other values</source>
        <translation>نص من 200 حرف على الأكثر؛ ونص آخر يعطي قيمًا أخرى</translation>
    </message>
    <message>
        <source>of an edition for students: the SHA-256 of the lab that it is of</source>
        <translation>لطبعة الطلاب: بصمة ⁦SHA-256⁩ للمختبر الذي هي منه</translation>
    </message>
    <message>
        <source>a unit like m/s of at most 40 characters</source>
        <translation>وحدة مثل ⁦m/s⁩ من 40 حرفًا على الأكثر</translation>
    </message>
    <message>
        <source>an object with format, id, title, commit, preset, hints, code_hints, prediction, remarks, checks, questions, values, moves, extra and locked</source>
        <translation>كائن فيه ⁦format, id, title, commit, preset, hints, code_hints, prediction, remarks, checks, questions, values, moves, extra, locked⁩</translation>
    </message>
    <message>
        <source>an object with format, id, title, version, language, values, draw and steps</source>
        <translation>كائن فيه ⁦format, id, title, version, language, values, draw, steps⁩</translation>
    </message>
    <message>
        <source>an object with id, kind, title, text, answers, right, unit, tolerance and points</source>
        <translation>كائن فيه ⁦id, kind, title, text, answers, right, unit, tolerance, points⁩</translation>
    </message>
    <message>
        <source>an object with numbers, expressions, or ranges with from, to and step, by their names</source>
        <translation>كائن فيه أعداد أو عبارات أو مجالات بـ from وto وstep، بحسب أسمائها</translation>
    </message>
    <message>
        <source>an object with the texts of the questions by their id</source>
        <translation>كائن فيه نصوص الأسئلة بحسب معرّفها</translation>
    </message>
    <message>
        <source>an object with title, hints, code_hints, prediction, checks, questions, mistakes and remarks</source>
        <translation>كائن فيه ⁦title, hints, code_hints, prediction, checks, questions, mistakes, remarks⁩</translation>
    </message>
    <message>
        <source>an object with title, text and answers</source>
        <translation>كائن فيه ⁦title, text, answers⁩</translation>
    </message>
    <message>
        <source>from one to the next, a number greater than 0</source>
        <translation>من واحد إلى التالي، عدد أكبر من 0</translation>
    </message>
    <message>
        <source>one of number, one, several, order, text</source>
        <translation>واحد من ⁦number, one, several, order, text⁩</translation>
    </message>
    <message>
        <source>the least, a number</source>
        <translation>الأدنى، عدد</translation>
    </message>
    <message>
        <source>the most, a number</source>
        <translation>الأقصى، عدد</translation>
    </message>
    <message>
        <source>the number of an answer, from 1</source>
        <translation>رقم إجابة، ابتداء من 1</translation>
    </message>
    <message>
        <source>what a right answer is worth, a number from 0 to 1000</source>
        <translation>قيمة الإجابة الصحيحة، عدد من 0 إلى 1000</translation>
    </message>
    <message>
        <source>1, the format that this version reads</source>
        <translation>1، الصيغة التي تقرؤها هذه النسخة</translation>
    </message>
    <message>
        <source>a circle number from 1</source>
        <translation>رقم دائرة ابتداء من 1</translation>
    </message>
    <message>
        <source>a colour like #1e90ff</source>
        <translation>لون مثل ⁦#1e90ff⁩</translation>
    </message>
    <message>
        <source>a language code like en or de</source>
        <translation>رمز لغة مثل en أو de</translation>
    </message>
    <message>
        <source>a list of checks</source>
        <translation>قائمة فحوص</translation>
    </message>
    <message>
        <source>a list of circle numbers from 1</source>
        <translation>قائمة أرقام دوائر ابتداء من 1</translation>
    </message>
    <message>
        <source>a list of circles, or an object with fill</source>
        <translation>قائمة دوائر، أو كائن فيه fill</translation>
    </message>
    <message>
        <source>a list of folder names, in order</source>
        <translation>قائمة أسماء مجلدات، بالترتيب</translation>
    </message>
    <message>
        <source>a list of remarks</source>
        <translation>قائمة تعقيبات</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>قائمة نصوص</translation>
    </message>
    <message>
        <source>a list of two to four answers</source>
        <translation>قائمة من إجابتين إلى أربع إجابات</translation>
    </message>
    <message>
        <source>a number in m from -10000 to 10000</source>
        <translation>عدد بوحدة m من ⁦-10000⁩ إلى 10000</translation>
    </message>
    <message>
        <source>a number in m/s from -1e7 to 1e7</source>
        <translation>عدد بوحدة ⁦m/s⁩ من ⁦-1e7⁩ إلى ⁦1e7⁩</translation>
    </message>
    <message>
        <source>a number in m/s² from -10000 to 10000</source>
        <translation>عدد بوحدة ⁦m/s²⁩ من ⁦-10000⁩ إلى 10000</translation>
    </message>
    <message>
        <source>a text of 1 to 100 characters</source>
        <translation>نص من 1 إلى 100 حرف</translation>
    </message>
    <message>
        <source>a text of 1 to 400 characters</source>
        <translation>نص من 1 إلى 400 حرف</translation>
    </message>
    <message>
        <source>a text of 1 to 1000 characters</source>
        <translation>نص من 1 إلى 1000 حرف</translation>
    </message>
    <message>
        <source>a text of at most 200 characters</source>
        <translation>نص من 200 حرف على الأكثر</translation>
    </message>
    <message>
        <source>a text of at most 2000 characters</source>
        <translation>نص من 2000 حرف على الأكثر</translation>
    </message>
    <message>
        <source>a whole number from 0 to 2147483647</source>
        <translation>عدد صحيح من 0 إلى 2147483647</translation>
    </message>
    <message>
        <source>an object that says which scenes the check runs: kind, count, duration, timesteps and what they vary</source>
        <translation>كائن يقول أيّ المشاهد يشغّلها الفحص: ⁦kind, count, duration, timesteps⁩ وما تنوّعه</translation>
    </message>
    <message>
        <source>an object with count and radius, and if wanted rms_speed, density, seed</source>
        <translation>كائن فيه count وradius، وعند الرغبة ⁦rms_speed, density, seed⁩</translation>
    </message>
    <message>
        <source>a list of fields of the scene that the student may not change</source>
        <translation>قائمة حقول من المشهد لا يجوز للطالب تغييرها</translation>
    </message>
    <message>
        <source>a field as gravity, restitution, timestep, half_width, circles, laws/walls, laws/circles, laws/timing or circles/1/velocity</source>
        <translation>حقل مثل ⁦gravity, restitution, timestep, half_width, circles, laws/walls, laws/circles, laws/timing⁩ أو ⁦circles/1/velocity⁩</translation>
    </message>
    <message>
        <source>an object with format, name, square, gravity, restitution, timestep, laws and circles</source>
        <translation>كائن فيه ⁦format, name, square, gravity, restitution, timestep, laws, circles⁩</translation>
    </message>
    <message>
        <source>an object with half_width</source>
        <translation>كائن فيه half_width</translation>
    </message>
    <message>
        <source>an object with id, compare and scene</source>
        <translation>كائن فيه ⁦id, compare, scene⁩</translation>
    </message>
    <message>
        <source>an object with id, kind, title, points, parameters and scene</source>
        <translation>كائن فيه ⁦id, kind, title, points, parameters, scene⁩</translation>
    </message>
    <message>
        <source>an object with position, and if wanted name, velocity, radius, density, colour, integrator</source>
        <translation>كائن فيه position، وعند الرغبة ⁦name, velocity, radius, density, colour, integrator⁩</translation>
    </message>
    <message>
        <source>an object with question, answers, right and outcome</source>
        <translation>كائن فيه ⁦question, answers, right, outcome⁩</translation>
    </message>
    <message>
        <source>an object with question, answers and outcome</source>
        <translation>كائن فيه ⁦question, answers, outcome⁩</translation>
    </message>
    <message>
        <source>an object with the parameters of the kind</source>
        <translation>كائن فيه معاملات النوع</translation>
    </message>
    <message>
        <source>an object with the texts of the mistakes by their name</source>
        <translation>كائن فيه نصوص الأخطاء بحسب اسمها</translation>
    </message>
    <message>
        <source>an object with the texts of the remarks by their name</source>
        <translation>كائن فيه نصوص التعقيبات بحسب اسمها</translation>
    </message>
    <message>
        <source>an object with the titles of the checks by their id</source>
        <translation>كائن فيه عناوين الفحوص بحسب معرّفها</translation>
    </message>
    <message>
        <source>an object with walls, circles and timing</source>
        <translation>كائن فيه ⁦walls, circles, timing⁩</translation>
    </message>
    <message>
        <source>half the side of the square in m, a number from 1e-6 to 10000</source>
        <translation>نصف ضلع المربع بوحدة m، عدد من ⁦1e-6⁩ إلى 10000</translation>
    </message>
    <message>
        <source>how many circles, a whole number from 1 to 100000</source>
        <translation>كم دائرة، عدد صحيح من 1 إلى 100000</translation>
    </message>
    <message>
        <source>one of discrete, continuous, exact</source>
        <translation>واحد من ⁦discrete, continuous, exact⁩</translation>
    </message>
    <message>
        <source>one of euler, symplectic_euler, verlet, rk4</source>
        <translation>واحدة من ⁦euler, symplectic_euler, verlet, rk4⁩</translation>
    </message>
    <message>
        <source>one of none, reflect</source>
        <translation>واحد من ⁦none, reflect⁩</translation>
    </message>
    <message>
        <source>one of none, stop, swap_velocities, swap_normal, impulse</source>
        <translation>واحد من ⁦none, stop, swap_velocities, swap_normal, impulse⁩</translation>
    </message>
    <message>
        <source>one of program, laws, either</source>
        <translation>واحد من ⁦program, laws, either⁩</translation>
    </message>
    <message>
        <source>one of velocities, positions, fields</source>
        <translation>واحد من ⁦velocities, positions, fields⁩</translation>
    </message>
    <message>
        <source>the coefficient of restitution e, a number from 0 to 1</source>
        <translation>معامل الارتداد e، عدد من 0 إلى 1</translation>
    </message>
    <message>
        <source>the density in 1000 kg/m³, a number from 1e-9 to 1e9</source>
        <translation>الكثافة بوحدة ⁦1000 kg/m³⁩، عدد من ⁦1e-9⁩ إلى ⁦1e9⁩</translation>
    </message>
    <message>
        <source>the name of a file beside task.json</source>
        <translation>اسم ملف بجوار ⁦task.json⁩</translation>
    </message>
    <message>
        <source>the name of a folder beside lab.json: letters, digits, dashes and underscores</source>
        <translation>اسم مجلد بجوار ⁦lab.json⁩: أحرف لاتينية وأرقام وشرطات وشرطات سفلية</translation>
    </message>
    <message>
        <source>the name of a kind of check</source>
        <translation>اسم نوع من الفحوص</translation>
    </message>
    <message>
        <source>the number of the answer that comes true, from 1</source>
        <translation>رقم الإجابة التي تتحقق، ابتداء من 1</translation>
    </message>
    <message>
        <source>the radius in m, a number from 1e-6 to 10000</source>
        <translation>نصف القطر بوحدة m، عدد من ⁦1e-6⁩ إلى 10000</translation>
    </message>
    <message>
        <source>the root mean square speed in m/s, a number from 0 to 1e6</source>
        <translation>الجذر التربيعي لمتوسط مربع السرعة بوحدة ⁦m/s⁩، عدد من 0 إلى ⁦1e6⁩</translation>
    </message>
    <message>
        <source>the timestep in s, a number from 1e-6 to 0.1</source>
        <translation>الخطوة الزمنية بوحدة s، عدد من ⁦1e-6⁩ إلى 0.1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>‏true أو false</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m, each from -10000 to 10000</source>
        <translation>عددان ⁦[x, y]⁩ بوحدة m، كلٌّ منهما من ⁦-10000⁩ إلى 10000</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s, each from -1e7 to 1e7</source>
        <translation>عددان ⁦[x, y]⁩ بوحدة ⁦m/s⁩، كلٌّ منهما من ⁦-1e7⁩ إلى ⁦1e7⁩</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s², each from -10000 to 10000</source>
        <translation>عددان ⁦[x, y]⁩ بوحدة ⁦m/s²⁩، كلٌّ منهما من ⁦-10000⁩ إلى 10000</translation>
    </message>
    <message>
        <source>what passing the check is worth, a number from 0 to 1000</source>
        <translation>قيمة اجتياز الفحص، عدد من 0 إلى 1000</translation>
    </message>
    <message>
        <source>what the step is worth, a number from 0 to 1000</source>
        <translation>قيمة المرحلة، عدد من 0 إلى 1000</translation>
    </message>
    <message>
        <source>how far off is still right, a number from 0 or an expression</source>
        <translation>مقدار الانحراف الذي يبقى صحيحًا، عدد من 0 فأكثر أو عبارة</translation>
    </message>
    <message>
        <source>a short name of letters, digits, dots, dashes and underscores</source>
        <translation>اسم قصير من أحرف لاتينية وأرقام ونقاط وشرطات وشرطات سفلية</translation>
    </message>
    <message>
        <source>an object with format and labs</source>
        <translation>كائن فيه format وlabs</translation>
    </message>
    <message>
        <source>an object with the progress in each lab by its id</source>
        <translation>كائن فيه التقدّم في كل مختبر بحسب معرّفه</translation>
    </message>
</context>
<context>
    <name>Script</name>
    <message>
        <source>there is no function check(run) … end</source>
        <translation>لا توجد دالة ⁦check(run) … end⁩</translation>
    </message>
    <message>
        <source>check(run) returned %1; true, or false and a message, is right</source>
        <translation>أعادت ⁦check(run)⁩ القيمة ⁨%1⁩؛ الصواب true، أو false ورسالة</translation>
    </message>
    <message>
        <source>check(run) returned false without a message for the student; return false, &quot;what is wrong&quot; is right</source>
        <translation>أعادت ⁦check(run)⁩ القيمة false بلا رسالة للطالب؛ الصواب false ثم نص يقول ما الخطأ</translation>
    </message>
    <message>
        <source>%1 has no field %2; a field has a name</source>
        <translation>ليس لـ ⁨%1⁩ حقل ⁨%2⁩؛ للحقل اسم</translation>
    </message>
    <message>
        <source>%1 has no field `%2`: did you mean `%3`?</source>
        <translation>ليس لـ ⁨%1⁩ حقل ⁦`%2`⁩: هل قصدت ⁦`%3`⁩؟</translation>
    </message>
    <message>
        <source>%1 has no field `%2`; it has %3. A field of your own must be set before it is read: %1.%2 = …</source>
        <translation>ليس لـ ⁨%1⁩ حقل ⁦`%2`⁩؛ له ⁨%3⁩. الحقل الخاص بك يجب أن يُضبط قبل أن يُقرأ: ⁦%1.%2 =⁩ …</translation>
    </message>
    <message>
        <source>%1 must be a vector, not %2; write vec(x, y)</source>
        <translation>يجب أن يكون ⁨%1⁩ متجهًا، لا ⁨%2⁩؛ اكتب ⁦vec(x, y)⁩</translation>
    </message>
    <message>
        <source>%1 would be %2; every number of a circle must be finite. Look for a division by zero, or for a value that grows in every step</source>
        <translation>سيصير ⁨%1⁩ القيمة ⁨%2⁩؛ يجب أن يكون كل عدد في الدائرة منتهيًا. ابحث عن قسمة على صفر، أو عن قيمة تنمو في كل خطوة</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2</source>
        <translation>يجب أن يكون ⁨%1⁩ عددًا، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 would be %2; it must be finite and above 0</source>
        <translation>سيصير ⁨%1⁩ القيمة ⁨%2⁩؛ يجب أن يكون منتهيًا وأكبر من 0</translation>
    </message>
    <message>
        <source>%1.index is given and cannot be changed</source>
        <translation>⁦%1.index⁩ معطى ولا يمكن تغييره</translation>
    </message>
    <message>
        <source>how many circles there are is #circles</source>
        <translation>عدد الدوائر هو ⁦#circles⁩</translation>
    </message>
    <message>
        <source>circles[i] takes a number from 1 to %1, not %2</source>
        <translation>تأخذ ⁦circles[i]⁩ عددًا من 1 إلى ⁨%1⁩، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>circles cannot be added or removed by a program; set the position and velocity of those that are there</source>
        <translation>لا يمكن لبرنامج أن يضيف دوائر أو يزيلها؛ اضبط موضع الموجودة وسرعتها</translation>
    </message>
    <message>
        <source>the program needs more than %1 MiB of memory; is there a table or a text that grows without end?</source>
        <translation>يحتاج البرنامج إلى أكثر من ⁦%1 MiB⁩ من الذاكرة؛ هل يوجد جدول أو نص ينمو بلا نهاية؟</translation>
    </message>
    <message>
        <source>the program called error with %1</source>
        <translation>استدعى البرنامج error بـ ⁨%1⁩</translation>
    </message>
    <message>
        <source>this is no text, so it is no program</source>
        <translation>هذا ليس نصًّا، فهو ليس برنامجًا</translation>
    </message>
    <message>
        <source>the author of this step has fixed this: %1. It stays as the scene has it; take this line out</source>
        <translation>ثبّت مؤلف هذه المرحلة هذا: ⁨%1⁩. يبقى كما هو في المشهد؛ احذف هذا السطر</translation>
    </message>
    <message>
        <source>`%1.%2` is not part of the lab&apos;s Lua; %1 has %3</source>
        <translation>ليس ⁦`%1.%2`⁩ من لغة Lua في المختبر؛ في ⁨%1⁩: ⁨%3⁩</translation>
    </message>
    <message>
        <source>%1 has no `%2`; it has %3</source>
        <translation>ليس في ⁨%1⁩ شيء اسمه ⁦`%2`⁩؛ فيه ⁨%3⁩</translation>
    </message>
    <message>
        <source>%1 has no `%2`: did you mean `%1.%3`?</source>
        <translation>ليس في ⁨%1⁩ شيء اسمه ⁦`%2`⁩: هل قصدت ⁦`%1.%3`⁩؟</translation>
    </message>
    <message>
        <source>&apos;%1&apos; expected (to close &apos;%2&apos; at line %3) near %4</source>
        <translation>يُتوقع &apos;⁨%1⁩&apos; (لإغلاق &apos;⁨%2⁩&apos; في السطر ⁨%3⁩) قرب ⁨%4⁩</translation>
    </message>
    <message>
        <source>%1 expected near %2</source>
        <translation>يُتوقع ⁨%1⁩ قرب ⁨%2⁩</translation>
    </message>
    <message>
        <source>unexpected symbol near %1</source>
        <translation>رمز غير متوقع قرب ⁨%1⁩</translation>
    </message>
    <message>
        <source>syntax error near %1</source>
        <translation>خطأ نحوي قرب ⁨%1⁩</translation>
    </message>
    <message>
        <source>unfinished string near %1</source>
        <translation>نص غير منتهٍ قرب ⁨%1⁩</translation>
    </message>
    <message>
        <source>unfinished long string (starting at line %1)</source>
        <translation>نص طويل غير منتهٍ (يبدأ في السطر ⁨%1⁩)</translation>
    </message>
    <message>
        <source>unfinished long comment (starting at line %1)</source>
        <translation>تعليق طويل غير منتهٍ (يبدأ في السطر ⁨%1⁩)</translation>
    </message>
    <message>
        <source>malformed number near %1</source>
        <translation>عدد مكتوب خطأً قرب ⁨%1⁩</translation>
    </message>
    <message>
        <source>invalid escape sequence near %1</source>
        <translation>تسلسل هروب غير صالح قرب ⁨%1⁩</translation>
    </message>
    <message>
        <source>break outside loop at line %1</source>
        <translation>الكلمة break خارج حلقة في السطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>no visible label &apos;%1&apos; for goto at line %2</source>
        <translation>لا توجد لافتة مرئية &apos;⁨%1⁩&apos; للأمر goto في السطر ⁨%2⁩</translation>
    </message>
    <message>
        <source>label &apos;%1&apos; already defined on line %2</source>
        <translation>اللافتة &apos;⁨%1⁩&apos; معرّفة بالفعل في السطر ⁨%2⁩</translation>
    </message>
    <message>
        <source>attempt to assign to const variable &apos;%1&apos;</source>
        <translation>محاولة إسناد إلى المتغير الثابت &apos;⁨%1⁩&apos;</translation>
    </message>
    <message>
        <source>attempt to compare two %1 values</source>
        <translation>محاولة مقارنة قيمتين من نوع ⁨%1⁩</translation>
    </message>
    <message>
        <source>attempt to compare %1 with %2</source>
        <translation>محاولة مقارنة ⁨%1⁩ بـ ⁨%2⁩</translation>
    </message>
    <message>
        <source>attempt to divide a whole number by zero</source>
        <translation>محاولة قسمة عدد صحيح على صفر</translation>
    </message>
    <message>
        <source>attempt to take the rest of a division by zero</source>
        <translation>محاولة أخذ باقي القسمة على صفر</translation>
    </message>
    <message>
        <source>%1 and %2 are no two numbers to calculate with</source>
        <translation>⁨%1⁩ و⁨%2⁩ ليسا عددين يُحسب بهما</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (%3 expected, got %4)</source>
        <translation>وسيط خاطئ رقم ⁨%1⁩ للدالة &apos;⁨%2⁩&apos; (المتوقع ⁨%3⁩، والموجود ⁨%4⁩)</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (number has no integer representation)</source>
        <translation>وسيط خاطئ رقم ⁨%1⁩ للدالة &apos;⁨%2⁩&apos; (لا يمكن تمثيل العدد عددًا صحيحًا)</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (out of range)</source>
        <translation>وسيط خاطئ رقم ⁨%1⁩ للدالة &apos;⁨%2⁩&apos; (خارج المجال)</translation>
    </message>
    <message>
        <source>number has no integer representation</source>
        <translation>لا يمكن تمثيل العدد عددًا صحيحًا</translation>
    </message>
    <message>
        <source>the first value of &apos;for&apos; must be a number</source>
        <translation>القيمة الأولى في ⁦&apos;for&apos;⁩ يجب أن تكون عددًا</translation>
    </message>
    <message>
        <source>the last value of &apos;for&apos; must be a number</source>
        <translation>القيمة الأخيرة في ⁦&apos;for&apos;⁩ يجب أن تكون عددًا</translation>
    </message>
    <message>
        <source>the step of &apos;for&apos; must be a number</source>
        <translation>خطوة ⁦&apos;for&apos;⁩ يجب أن تكون عددًا</translation>
    </message>
    <message>
        <source>the step of &apos;for&apos; is zero</source>
        <translation>خطوة ⁦&apos;for&apos;⁩ صفر</translation>
    </message>
    <message>
        <source>assertion failed!</source>
        <translation>أخفق assert!</translation>
    </message>
    <message>
        <source>&lt;eof&gt;</source>
        <extracomment>the end of the program</extracomment>
        <translation>&lt;نهاية الملف&gt;</translation>
    </message>
    <message>
        <source>&lt;name&gt;</source>
        <translation>&lt;اسم&gt;</translation>
    </message>
    <message>
        <source>this value</source>
        <translation>هذه القيمة</translation>
    </message>
    <message>
        <source>%1 is %2, so it has no fields</source>
        <translation>⁨%1⁩ هو ⁨%2⁩، فليس له حقول</translation>
    </message>
    <message>
        <source>%1 is %2, not a function that can be called</source>
        <translation>⁨%1⁩ هو ⁨%2⁩، لا دالة يمكن استدعاؤها</translation>
    </message>
    <message>
        <source>%1 is %2, not a number to calculate with</source>
        <translation>⁨%1⁩ هو ⁨%2⁩، لا عدد يُحسب به</translation>
    </message>
    <message>
        <source>%1 is %2, so .. cannot join it to a text</source>
        <translation>⁨%1⁩ هو ⁨%2⁩، فلا تستطيع .. وصله بنص</translation>
    </message>
    <message>
        <source>%1 is %2, so it has no length</source>
        <translation>⁨%1⁩ هو ⁨%2⁩، فليس له طول</translation>
    </message>
    <message>
        <source>%1; only numbers compare with numbers (the length of a vector is v:length())</source>
        <translation>⁨%1⁩؛ لا تُقارن بالأعداد إلا الأعداد (طول المتجه هو ⁦v:length()⁩)</translation>
    </message>
    <message>
        <source>a function calls itself without end (stack overflow)</source>
        <translation>دالة تستدعي نفسها بلا نهاية (فاض المكدّس)</translation>
    </message>
    <message>
        <source>. There is no circles[%1]: circles are counted from 1 to %2</source>
        <translation>. لا يوجد ⁦circles[%1]⁩: تُعدّ الدوائر من 1 إلى ⁨%2⁩</translation>
    </message>
    <message>
        <source>. The length of a list is #%1</source>
        <translation>. طول القائمة هو ⁦#%1⁩</translation>
    </message>
    <message>
        <source>. Texts are joined by .., not by +</source>
        <translation>. تُوصل النصوص بـ .. لا بـ +</translation>
    </message>
    <message>
        <source>. A function is called with its parentheses, and that of a vector with a colon: v:length()</source>
        <translation>. تُستدعى الدالة بقوسيها، ودالة المتجه بنقطتين: ⁦v:length()⁩</translation>
    </message>
    <message>
        <source>`%1.%2` is %3 in Lua</source>
        <translation>⁦`%1.%2`⁩ هو ⁨%3⁩ في Lua</translation>
    </message>
    <message>
        <source>Lua has no null; nothing is written nil</source>
        <translation>ليس في Lua الكلمة null؛ اللاشيء يُكتب nil</translation>
    </message>
    <message>
        <source>there is no `%1` here; the circles are circle1, circle2 …, and what is your own has its plain name</source>
        <translation>لا يوجد ⁦`%1`⁩ هنا؛ الدوائر هي ⁦circle1, circle2⁩ …، وما يخصك له اسمه المجرّد</translation>
    </message>
    <message>
        <source>Lua has no `new`; a vector is made by vec(x, y), a table by {}</source>
        <translation>ليس في Lua الكلمة ⁦`new`⁩؛ يُصنع المتجه بـ ⁦vec(x, y)⁩، والجدول بـ ⁦{}⁩</translation>
    </message>
    <message>
        <source>`%1` is not known; a vector is made by vec(x, y)</source>
        <translation>⁦`%1`⁩ غير معروف؛ يُصنع المتجه بـ ⁦vec(x, y)⁩</translation>
    </message>
    <message>
        <source>`%1` is not known; print(…) writes to the console</source>
        <translation>⁦`%1`⁩ غير معروف؛ ⁦print(…)⁩ تكتب في وحدة الإخراج</translation>
    </message>
    <message>
        <source>`%1` is not known; // divides, a comment begins with -- in Lua</source>
        <translation>⁦`%1`⁩ غير معروف؛ // تقسم، والتعليق في Lua يبدأ بـ --</translation>
    </message>
    <message>
        <source>`%1` is not known yet: it is local and stands below, in line %2; move it up, or leave out `local`</source>
        <translation>⁦`%1`⁩ غير معروف بعد: هو محلي ويرد أدناه، في السطر ⁨%2⁩؛ انقله إلى أعلى، أو احذف ⁦`local`⁩</translation>
    </message>
    <message>
        <source>`%1` is not known here: it is local to the block of line %2; declare it before that block</source>
        <translation>⁦`%1`⁩ غير معروف هنا: هو محلي في كتلة السطر ⁨%2⁩؛ صرّح به قبل تلك الكتلة</translation>
    </message>
    <message>
        <source>pairs needs keys that have an order: numbers, texts, circles. Of tables, functions and equal vectors there may be one; keep them in a list and go through it with ipairs</source>
        <translation>تحتاج pairs إلى مفاتيح لها ترتيب: أعداد ونصوص ودوائر. أما الجداول والدوال والمتجهات المتساوية فيجوز منها واحد؛ احفظها في قائمة وامش عليها بـ ipairs</translation>
    </message>
    <message>
        <source>pairs goes through a table or circles, not %1</source>
        <translation>تمشي pairs على جدول أو على circles، لا على ⁨%1⁩</translation>
    </message>
    <message>
        <source>Lua has no foreach; write: for _, %1 in ipairs(%2) do … end</source>
        <translation>ليس في Lua الكلمة foreach؛ اكتب: ⁦for _, %1 in ipairs(%2) do … end⁩</translation>
    </message>
    <message>
        <source>a loop that counts is written: for %1 = first, last do … end, both included</source>
        <translation>الحلقة التي تعدّ تُكتب: ⁦for %1 = first, last do … end⁩، والطرفان داخلان</translation>
    </message>
    <message>
        <source>Lua has no =&gt;; a function is function(x) return … end, and &quot;greater or equal&quot; is &gt;=</source>
        <translation>ليس في Lua الرمز ⁦=&gt;⁩؛ الدالة هي ⁦function(x) return … end⁩، و«أكبر أو يساوي» هو ⁦&gt;=⁩</translation>
    </message>
    <message>
        <source>Lua has no ? : to choose; write: if … then … else … end, or: condition and a or b</source>
        <translation>ليس في Lua الرمزان ⁦? :⁩ للاختيار؛ اكتب: ⁦if … then … else … end⁩، أو: ⁦condition and a or b⁩</translation>
    </message>
    <message>
        <source>Lua has no %2=; write %1 = %1 %2 %3</source>
        <translation>ليس في Lua الرمز ⁦%2=⁩؛ اكتب ⁦%1 = %1 %2 %3⁩</translation>
    </message>
    <message>
        <source>&quot;not equal&quot; is ~= in Lua, not !=</source>
        <translation>«لا يساوي» في Lua هو ⁦~=⁩، لا ⁦!=⁩</translation>
    </message>
    <message>
        <source>Lua has no ++; write %1 = %1 + 1</source>
        <translation>ليس في Lua الرمز ++؛ اكتب ⁦%1 = %1 + 1⁩</translation>
    </message>
    <message>
        <source>Lua writes `and`, `or`, `not` in words</source>
        <translation>تكتب Lua الكلمات ⁦`and`⁩، ⁦`or`⁩، ⁦`not`⁩ بالحروف</translation>
    </message>
    <message>
        <source>Lua writes `not` in words, not !</source>
        <translation>تكتب Lua الكلمة ⁦`not`⁩ بالحروف، لا !</translation>
    </message>
    <message>
        <source>Lua names no types; a function is written: function %1(…) … end</source>
        <translation>لا تسمّي Lua الأنواع؛ تُكتب الدالة: ⁦function %1(…) … end⁩</translation>
    </message>
    <message>
        <source>Lua names no types; write: local %1 = …</source>
        <translation>لا تسمّي Lua الأنواع؛ اكتب: ⁦local %1 =⁩ …</translation>
    </message>
    <message>
        <source>Lua names no types; of a parameter write only the name: %1</source>
        <translation>لا تسمّي Lua الأنواع؛ من المعامل اكتب الاسم فقط: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Lua has no `%1`</source>
        <translation>ليس في Lua الكلمة ⁦`%1`⁩</translation>
    </message>
    <message>
        <source>Lua has no `continue`; put what it leaves out into an if</source>
        <translation>ليس في Lua الكلمة ⁦`continue`⁩؛ ضع ما تتخطاه داخل if</translation>
    </message>
    <message>
        <source>a comment begins with -- in Lua</source>
        <translation>يبدأ التعليق في Lua بـ --</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: if … then … else … end</source>
        <translation>لا أقواس معقوفة حول الكتل في Lua؛ اكتب: ⁦if … then … else … end⁩</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: while … do … end</source>
        <translation>لا أقواس معقوفة حول الكتل في Lua؛ اكتب: ⁦while … do … end⁩</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: for … do … end</source>
        <translation>لا أقواس معقوفة حول الكتل في Lua؛ اكتب: ⁦for … do … end⁩</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: function name(…) … end</source>
        <translation>لا أقواس معقوفة حول الكتل في Lua؛ اكتب: ⁦function name(…) … end⁩</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; a block ends with `end`</source>
        <translation>لا أقواس معقوفة حول الكتل في Lua؛ تنتهي الكتلة بـ ⁦`end`⁩</translation>
    </message>
    <message>
        <source>= assigns; to compare write ==</source>
        <translation>الرمز = يُسند؛ للمقارنة اكتب ==</translation>
    </message>
    <message>
        <source>== compares; to assign write =</source>
        <translation>الرمز == يقارن؛ للإسناد اكتب =</translation>
    </message>
    <message>
        <source>names have the letters a to z, digits and _ only</source>
        <translation>في الأسماء الأحرف من a إلى z والأرقام و_ فقط</translation>
    </message>
    <message>
        <source>Lua has no --, which begins a comment; write %1 = %1 - 1</source>
        <translation>ليس في Lua الإنقاص بـ --، فهو يبدأ تعليقًا؛ اكتب ⁦%1 = %1 - 1⁩</translation>
    </message>
    <message>
        <source>return ends its block: nothing may follow it there but end, else or elseif</source>
        <translation>الكلمة return تنهي كتلتها: لا يجوز أن يتبعها هناك إلا end أو else أو elseif</translation>
    </message>
    <message>
        <source>here `%1` is missing</source>
        <translation>ينقص هنا ⁦`%1`⁩</translation>
    </message>
    <message>
        <source>an `end` is missing: `else if` begins a second if, which needs an `end` of its own; the one word elseif does not</source>
        <translation>تنقص ⁦`end`⁩: تبدأ ⁦`else if`⁩ شرطًا ثانيًا يحتاج إلى ⁦`end`⁩ خاصة به؛ أما الكلمة الواحدة elseif فلا</translation>
    </message>
    <message>
        <source>write %1, with a colon</source>
        <translation>اكتب ⁨%1⁩، بنقطتين</translation>
    </message>
    <message>
        <source>the moment must be a number of seconds from 0 to %1, not %2</source>
        <translation>يجب أن تكون اللحظة عددًا من الثواني من 0 إلى ⁨%1⁩، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>this must be a whole number from %1 to %2, not %3</source>
        <translation>يجب أن يكون هذا عددًا صحيحًا من ⁨%1⁩ إلى ⁨%2⁩، لا ⁨%3⁩</translation>
    </message>
    <message>
        <source>this step does as much work as %1 million instructions (what is done to long texts and lists counts by their length); is there a loop that does not end?</source>
        <translation>تبذل هذه الخطوة عملًا يعادل ⁨%1⁩ مليون تعليمة (ما يُفعل بالنصوص والقوائم الطويلة يُحسب بطولها)؛ هل توجد حلقة لا تنتهي؟</translation>
    </message>
    <message>
        <source>this step takes more than %1 million instructions; is there a loop that does not end?</source>
        <translation>تستغرق هذه الخطوة أكثر من ⁨%1⁩ مليون تعليمة؛ هل توجد حلقة لا تنتهي؟</translation>
    </message>
    <message>
        <source>this step has run for more than %1 s; is there a loop that does not end?</source>
        <translation>دامت هذه الخطوة أكثر من ⁦%1 s⁩؛ هل توجد حلقة لا تنتهي؟</translation>
    </message>
    <message>
        <source>the run was stopped</source>
        <translation>أُوقف التشغيل</translation>
    </message>
    <message>
        <source>functions call each other %1 deep; does one call itself without end?</source>
        <translation>تستدعي الدوال بعضها بعضًا بعمق ⁨%1⁩؛ هل تستدعي واحدة نفسها بلا نهاية؟</translation>
    </message>
    <message>
        <source>the program has %1 letters; at most %2 are right</source>
        <translation>عدد حروف البرنامج ⁨%1⁩؛ الصواب ⁨%2⁩ على الأكثر</translation>
    </message>
    <message>
        <source>there is no memory to run a program</source>
        <translation>لا ذاكرة لتشغيل برنامج</translation>
    </message>
    <message>
        <source>`%1` is local here, so nobody can call it; write function %1(…) without local</source>
        <translation>⁦`%1`⁩ محلية هنا، فلا يستطيع أحد استدعاءها؛ اكتب ⁦function %1(…)⁩ بلا local</translation>
    </message>
    <message>
        <source>the program shows more than %1 KiB in one step</source>
        <translation>يعرض البرنامج أكثر من ⁦%1 KiB⁩ في خطوة واحدة</translation>
    </message>
    <message>
        <source>%1 must be a text, not %2</source>
        <translation>يجب أن يكون ⁨%1⁩ نصًّا، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>the name in plot(name, number)</source>
        <translation>الاسم في ⁦plot(name, number)⁩</translation>
    </message>
    <message>
        <source>the name in plot(name, number) must have 1 to %1 letters</source>
        <translation>يجب أن يكون الاسم في ⁦plot(name, number)⁩ من 1 إلى ⁨%1⁩ حرفًا</translation>
    </message>
    <message>
        <source>plot(name, number) takes a number, not %1</source>
        <translation>تأخذ ⁦plot(name, number)⁩ عددًا، لا ⁨%1⁩</translation>
    </message>
    <message>
        <source>plot(&quot;%1&quot;, …) would be %2; a finite number is right</source>
        <translation>ستصير ⁦plot(&quot;%1&quot;, …)⁩ القيمة ⁨%2⁩؛ الصواب عدد منتهٍ</translation>
    </message>
    <message>
        <source>%1 would draw at %2; finite numbers are right</source>
        <translation>سترسم ⁨%1⁩ عند ⁨%2⁩؛ الصواب أعداد منتهية</translation>
    </message>
    <message>
        <source>%1 would end beyond all numbers</source>
        <translation>ستنتهي ⁨%1⁩ وراء كل الأعداد</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>لون</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>تسمية</translation>
    </message>
    <message>
        <source>the text in draw.text(p, text)</source>
        <translation>النص في ⁦draw.text(p, text)⁩</translation>
    </message>
    <message>
        <source>draw has no `%1`; it has %2</source>
        <translation>ليس في draw شيء اسمه ⁦`%1`⁩؛ فيه ⁨%2⁩</translation>
    </message>
    <message>
        <source>draw has no `%1`: did you mean `%2`?</source>
        <translation>ليس في draw شيء اسمه ⁦`%1`⁩: هل قصدت ⁦`%2`⁩؟</translation>
    </message>
    <message>
        <source>square has no `%1`; it has %2</source>
        <translation>ليس في square شيء اسمه ⁦`%1`⁩؛ فيه ⁨%2⁩</translation>
    </message>
    <message>
        <source>square has no `%1`: did you mean `%2`?</source>
        <translation>ليس في square شيء اسمه ⁦`%1`⁩: هل قصدت ⁦`%2`⁩؟</translation>
    </message>
    <message>
        <source>the square can only be read</source>
        <translation>لا يمكن إلا قراءة square</translation>
    </message>
    <message>
        <source>there is no field `%1` here; there are %2</source>
        <translation>لا يوجد حقل ⁦`%1`⁩ هنا؛ الحقول ⁨%2⁩</translation>
    </message>
    <message>
        <source>there is no field `%1` here: did you mean `%2`?</source>
        <translation>لا يوجد حقل ⁦`%1`⁩ هنا: هل قصدت ⁦`%2`⁩؟</translation>
    </message>
    <message>
        <source>after on_load the scene cannot be run: %1</source>
        <translation>بعد on_load لا يمكن تشغيل المشهد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>`on_update` is no function any more; it is given once: function on_update(timestep) … end</source>
        <translation>لم تعد ⁦`on_update`⁩ دالة؛ تُعطى مرة واحدة: ⁦function on_update(timestep) … end⁩</translation>
    </message>
    <message>
        <source>%p of string.format is not part of the lab&apos;s Lua: an address is another in every run</source>
        <translation>الرمز ⁦%p⁩ في ⁦string.format⁩ ليس من لغة Lua في المختبر: العنوان يختلف في كل تشغيل</translation>
    </message>
    <message>
        <source>the vector %1</source>
        <translation>المتجه ⁨%1⁩</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>العدد ⁨%1⁩</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>النص ⁨%1⁩</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>جدول</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>دالة</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>لا شيء</translation>
    </message>
    <message>
        <source>%1 %2 %3 has no meaning: %4</source>
        <translation>ليس لـ ⁨%1⁩ ⁨%2⁩ ⁨%3⁩ معنى: ⁨%4⁩</translation>
    </message>
    <message>
        <source>a vector is added to a vector</source>
        <translation>المتجه يُجمع مع متجه</translation>
    </message>
    <message>
        <source>a vector is taken from a vector</source>
        <translation>المتجه يُطرح من متجه</translation>
    </message>
    <message>
        <source>a vector is multiplied by a number; for the dot product write a:dot(b)</source>
        <translation>المتجه يُضرب في عدد؛ وللجداء السلّمي اكتب ⁦a:dot(b)⁩</translation>
    </message>
    <message>
        <source>a vector is divided by a number</source>
        <translation>المتجه يُقسم على عدد</translation>
    </message>
    <message>
        <source>a vector has no `%1`; it has %2</source>
        <translation>ليس للمتجه ⁦`%1`⁩؛ له ⁨%2⁩</translation>
    </message>
    <message>
        <source>a vector has no `%1`: did you mean `%2`?</source>
        <translation>ليس للمتجه ⁦`%1`⁩: هل قصدت ⁦`%2`⁩؟</translation>
    </message>
    <message>
        <source>a vector cannot be changed; build a new one: %1 = %2</source>
        <translation>لا يمكن تغيير متجه؛ ابنِ واحدًا جديدًا: ⁦%1 = %2⁩</translation>
    </message>
    <message>
        <source>`%1` belongs to a vector; write v:%1(), with a colon</source>
        <translation>⁦`%1`⁩ من دوال المتجه؛ اكتب ⁦v:%1()⁩، بنقطتين</translation>
    </message>
    <message>
        <source>the vector (0, 0) has no direction, so it cannot be normalized</source>
        <translation>ليس للمتجه ⁦(0, 0)⁩ اتجاه، فلا يمكن جعل طوله 1</translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers; %1 is %2</source>
        <translation>تأخذ ⁦vec(x, y)⁩ عددين؛ و⁨%1⁩ هو ⁨%2⁩</translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers, not %1</source>
        <translation>تأخذ ⁦vec(x, y)⁩ عددين، لا ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 needs a vector, not %2</source>
        <translation>تحتاج ⁨%1⁩ إلى متجه، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>dot got one vector and takes two: write a:dot(b) with a colon, or dot(a, b)</source>
        <translation>أُعطيت ⁦dot⁩ متجهًا واحدًا وهي تأخذ متجهين: اكتب ⁦a:dot(b)⁩ بنقطتين، أو ⁦dot(a, b)⁩</translation>
    </message>
    <message>
        <source>`%1` is not known: nothing of that name was given a value before</source>
        <translation>⁦`%1`⁩ غير معروف: لم يُعطَ شيء بهذا الاسم قيمةً من قبل</translation>
    </message>
    <message>
        <source>there is no %1: the scene has 1 circle</source>
        <translation>لا يوجد ⁨%1⁩: في المشهد دائرة واحدة</translation>
    </message>
    <message>
        <source>there is no %1: the scene has %2 circles</source>
        <translation>لا يوجد ⁨%1⁩: عدد دوائر المشهد ⁨%2⁩</translation>
    </message>
    <message>
        <source>`%1` is not known: did you mean `%2`?</source>
        <translation>⁦`%1`⁩ غير معروف: هل قصدت ⁦`%2`⁩؟</translation>
    </message>
    <message>
        <source>`%1` is set once, in on_load; in on_update it can only be read</source>
        <translation>يُضبط ⁦`%1`⁩ مرة واحدة، في on_load؛ وفي on_update لا يمكن إلا قراءته</translation>
    </message>
    <message>
        <source>gravity would be %1 m/s²; at most %2 is right</source>
        <translation>ستصير gravity القيمة ⁦%1 m/s²⁩؛ الصواب ⁨%2⁩ على الأكثر</translation>
    </message>
    <message>
        <source>restitution must be a number from 0 to 1, not %1</source>
        <translation>يجب أن يكون restitution عددًا من 0 إلى 1، لا ⁨%1⁩</translation>
    </message>
    <message>
        <source>`%1` can only be read; choose another name for a variable of your own</source>
        <translation>لا يمكن إلا قراءة ⁦`%1`⁩؛ اختر اسمًا آخر لمتغير خاص بك</translation>
    </message>
    <message>
        <source>`%1` is given by the lab and cannot be replaced; choose another name for a variable of your own</source>
        <translation>⁦`%1`⁩ يعطيه المختبر ولا يمكن استبداله؛ اختر اسمًا آخر لمتغير خاص بك</translation>
    </message>
    <message>
        <source>`%1` must be a function, not %2</source>
        <translation>يجب أن يكون ⁦`%1`⁩ دالة، لا ⁨%2⁩</translation>
    </message>
    <message>
        <source>`%1` is not known yet: a local can be used only after the statement that makes it</source>
        <translation>⁦`%1`⁩ غير معروف بعد: لا يُستعمل المتغير المحلي إلا بعد التعليمة التي تنشئه</translation>
    </message>
    <message>
        <source>`%1` is not known here; how long a step lasts is the parameter of on_update, which other functions get as an argument</source>
        <translation>⁦`%1`⁩ غير معروف هنا؛ مدة الخطوة هي معامل on_update، وتُعطى للدوال الأخرى وسيطًا</translation>
    </message>
    <message>
        <source>`%1` is not part of the lab&apos;s Lua; see the API page (F1) for what is</source>
        <translation>⁦`%1`⁩ ليس من لغة Lua في المختبر؛ انظر صفحة المرجع ⁦(F1)⁩ لما هو منها</translation>
    </message>
    <message>
        <source>. Look at what the call in line %1 gives for it</source>
        <translation>. انظر ماذا يعطيه الاستدعاء في السطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>`%1` is not known here: it is local to another block, in line %2; a function gets what it needs as an argument, or makes it itself</source>
        <translation>⁦`%1`⁩ غير معروف هنا: هو محلي في كتلة أخرى، في السطر ⁨%2⁩؛ ما تحتاج إليه الدالة يُعطى لها وسيطًا أو تصنعه بنفسها</translation>
    </message>
    <message>
        <source>%1 has no field `%2`: it belongs to the whole world; write `%2` alone</source>
        <translation>ليس لـ ⁨%1⁩ حقل `%2`: فهو للعالم كله؛ اكتب `%2` وحده</translation>
    </message>
    <message>
        <source>%1 must be a vector, not nil: what it is to become has no value here</source>
        <translation>يجب أن يكون ⁨%1⁩ متجهًا، لا nil: ما يُسنَد إليه لا قيمة له هنا</translation>
    </message>
    <message>
        <source>%1 would be %2 here: the comma ends a value; a number has a point, %2.%3</source>
        <translation>ستكون قيمة ⁨%1⁩ هنا ⁦%2⁩: الفاصلة تُنهي القيمة؛ يُكتب العدد بنقطة، ⁦%2.%3⁩</translation>
    </message>
    <message>
        <source>a vector is multiplied by a number</source>
        <translation>يُضرب المتجه في عدد</translation>
    </message>
    <message>
        <source>gravity must be a vector in m/s², not %1; write gravity = vec(0, %2)</source>
        <translation>يجب أن تكون gravity متجهًا بوحدة ⁦m/s²⁩، لا ⁨%1⁩؛ اكتب ⁦gravity = vec(0, %2)⁩</translation>
    </message>
    <message>
        <source>parentheses, blocks or terms are nested too deeply</source>
        <translation>الأقواس أو الكتل أو الحدود متداخلة أعمق مما ينبغي</translation>
    </message>
    <message>
        <source>%1 is not the minus of Lua; write -</source>
        <translation>ليس ⁨%1⁩ علامة الطرح في Lua؛ اكتب ⁨-⁩</translation>
    </message>
    <message>
        <source>Lua does not know the sign %1</source>
        <translation>لا تعرف Lua العلامة ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>Trails</name>
    <message>
        <source>centre of mass</source>
        <translation>مركز الكتلة</translation>
    </message>
</context>
<context>
    <name>UnifiedDiff</name>
    <message>
        <source>this is no line of a difference; “@@ -4,3 +4,2 @@” or a line after blank, minus or plus is right</source>
        <translation>هذا ليس سطر فرق؛ الصواب «⁦@@ -4,3 +4,2 @@⁩» أو سطر بعد فراغ أو ناقص أو زائد</translation>
    </message>
    <message>
        <source>the lines that this changes are not there any more</source>
        <translation>الأسطر التي يغيّرها هذا لم تعد هناك</translation>
    </message>
</context>
<context>
    <name>Variant</name>
    <message>
        <source>timestep 1/%1 s</source>
        <translation>خطوة زمنية ⁦1/%1 s⁩</translation>
    </message>
    <message>
        <source>throw %1</source>
        <translation>الرمية ⁨%1⁩</translation>
    </message>
    <message>
        <source>circle %1 towards %2°</source>
        <translation>الدائرة ⁨%1⁩ نحو ⁦%2°⁩</translation>
    </message>
    <message>
        <source>drop %1</source>
        <translation>الإسقاط ⁨%1⁩</translation>
    </message>
    <message>
        <source>slow hit %1</source>
        <translation>التصادم البطيء ⁨%1⁩</translation>
    </message>
    <message>
        <source>contact at %1°</source>
        <translation>تلامس عند ⁦%1°⁩</translation>
    </message>
    <message>
        <source>parting at %1°</source>
        <translation>افتراق عند ⁦%1°⁩</translation>
    </message>
    <message>
        <source>contact %1, in front of a wall</source>
        <translation>التلامس ⁨%1⁩، أمام جدار</translation>
    </message>
    <message>
        <source>slowly to one side</source>
        <translation>ببطء إلى جانب</translation>
    </message>
    <message>
        <source>slowly to the other side</source>
        <translation>ببطء إلى الجانب الآخر</translation>
    </message>
    <message>
        <source>let go low %1</source>
        <translation>ترك من ارتفاع صغير ⁨%1⁩</translation>
    </message>
    <message>
        <source>two hits on one line %1</source>
        <translation>تصادمان على خط واحد ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>the history of your work cannot be kept: %1</source>
        <translation>يتعذر حفظ تاريخ عملك: ⁨%1⁩</translation>
    </message>
    <message>
        <source>there is no git repository at this address</source>
        <translation>لا يوجد مستودع git في هذا العنوان</translation>
    </message>
    <message>
        <source>there is other work at this address, which yours does not go on from; give another address</source>
        <translation>في هذا العنوان عمل آخر لا يأتي عملك امتدادًا له؛ أعطِ عنوانًا آخر</translation>
    </message>
    <message>
        <source>this is no address of a git repository</source>
        <translation>هذا ليس عنوان مستودع git</translation>
    </message>
    <message>
        <source>there is no address to share with yet</source>
        <translation>لا يوجد عنوان للمشاركة معه بعد</translation>
    </message>
    <message>
        <source>your work could not be sent: %1</source>
        <translation>تعذّر إرسال عملك: ⁨%1⁩</translation>
    </message>
    <message>
        <source>the other side did not take your work: %1</source>
        <translation>لم يقبل الطرف الآخر عملك: ⁨%1⁩</translation>
    </message>
    <message>
        <source>your program cannot be saved here: %1</source>
        <translation>لا يمكن حفظ برنامجك هنا: ⁨%1⁩</translation>
    </message>
    <message>
        <source>another window works on this lab now; this one saves nothing more, and what was typed last here is among the versions of the step</source>
        <translation>تعمل نافذة أخرى على هذا المختبر الآن؛ هذه لا تحفظ شيئًا بعد، وما كُتب هنا أخيرًا بين نسخ المرحلة</translation>
    </message>
    <message>
        <source>the file cannot be moved aside</source>
        <translation>لا يمكن نقل الملف جانبًا</translation>
    </message>
    <message>
        <source>your work cannot be saved here: %1</source>
        <translation>لا يمكن حفظ عملك هنا: ⁨%1⁩</translation>
    </message>
    <message>
        <source>this does not say whose work it is, as cradle.json of format 1 does</source>
        <translation>هذا لا يقول عمل من هو، كما يفعل ⁦cradle.json⁩ بالصيغة 1</translation>
    </message>
    <message>
        <source>another window works on this lab now; this one saves nothing more</source>
        <translation>تعمل نافذة أخرى على هذا المختبر الآن؛ هذه لا تحفظ شيئًا بعد</translation>
    </message>
    <message>
        <source>another program has changed this note; yours stays, and the other is kept in git as refs/cradle/notes/%1</source>
        <translation>غيّر برنامج آخر هذه الملاحظة؛ تبقى ملاحظتك، وتُحفظ الأخرى في git باسم ⁦refs/cradle/notes/%1⁩</translation>
    </message>
    <message>
        <source>this file is no note; it is kept as %1</source>
        <translation>هذا الملف ليس ملاحظة؛ يُحفظ باسم ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::Announcer</name>
    <message>
        <source>Hit at %1 s: %2 and %3, impulse %4 N s</source>
        <translation>تصادم عند ⁦%1 s⁩: ⁨%2⁩ و⁨%3⁩، الدفع ⁦%4 N s⁩</translation>
    </message>
</context>
<context>
    <name>cradle::ApiPage</name>
    <message>
        <source>:/help/lua-api.md</source>
        <extracomment>The file of the page in your language: docs/lua-api.LANGUAGE.md, if there is one</extracomment>
        <translation>:/help/lua-api.ar.md</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>مرجع اللغة</translation>
    </message>
    <message>
        <source>Search (Return: next place in the text)</source>
        <translation>بحث (Enter: الموضع التالي في النص)</translation>
    </message>
    <message>
        <source>Search the API reference</source>
        <translation>بحث في مرجع اللغة</translation>
    </message>
    <message>
        <source>Entries of the API reference</source>
        <translation>مداخل مرجع اللغة</translation>
    </message>
    <message>
        <source>Not found in the reference: %1</source>
        <translation>غير موجود في المرجع: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::ArrangementDialog</name>
    <message>
        <source>Rows</source>
        <translation>الصفوف</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>الأعمدة</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>الدوائر</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>نصف القطر</translation>
    </message>
    <message>
        <source>Gap between rims</source>
        <translation>الفجوة بين الحافتين</translation>
    </message>
    <message>
        <source>One more comes from the left</source>
        <translation>دائرة أخرى تأتي من اليسار</translation>
    </message>
    <message numerus="yes">
        <source>%n circle(s)</source>
        <translation>
            <numerusform>لا دوائر</numerusform>
            <numerusform>دائرة واحدة</numerusform>
            <numerusform>دائرتان</numerusform>
            <numerusform>%n دوائر</numerusform>
            <numerusform>%n دائرة</numerusform>
            <numerusform>%n دائرة</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::AuthorDocument</name>
    <message>
        <source>This lab ships with Cradle and stays as it is; make a copy of it to change that</source>
        <translation>هذا المختبر مرفق مع Cradle ويبقى كما هو؛ اصنع نسخة منه لتغييره</translation>
    </message>
    <message>
        <source>New lab</source>
        <translation>مختبر جديد</translation>
    </message>
    <message>
        <source>Changes that were not saved</source>
        <translation>تغييرات لم تُحفظ</translation>
    </message>
    <message>
        <source>the folder is not empty; a new or an empty one is right</source>
        <translation>المجلد ليس فارغًا؛ الصواب مجلد جديد أو فارغ</translation>
    </message>
    <message>
        <source>Reload from the folder</source>
        <translation>إعادة التحميل من المجلد</translation>
    </message>
    <message>
        <source>Take what another program changed</source>
        <translation>أخذ ما غيّره برنامج آخر</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorExports</name>
    <message>
        <source>Labs (*.cradle);;All files (*)</source>
        <translation>مختبرات (*.cradle);;كل الملفات (*)</translation>
    </message>
    <message>
        <source>Not all of it can be read</source>
        <translation>تتعذر قراءته كله</translation>
    </message>
    <message>
        <source>Students will not find what cannot be read:</source>
        <translation>لن يجد الطلاب ما تتعذر قراءته:</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>تصدير على أي حال</translation>
    </message>
    <message>
        <source>Export the lab for students</source>
        <translation>تصدير المختبر للطلاب</translation>
    </message>
    <message numerus="yes">
        <source>Exported without %n file(s) that are yours: %1</source>
        <translation>
            <numerusform>صُدّر دون ترك أي ملف: ⁨%1⁩</numerusform>
            <numerusform>صُدّر دون ملف واحد يخصّك: ⁨%1⁩</numerusform>
            <numerusform>صُدّر دون ملفين يخصّانك: ⁨%1⁩</numerusform>
            <numerusform>صُدّر دون %n ملفات تخصّك: ⁨%1⁩</numerusform>
            <numerusform>صُدّر دون %n ملفًا يخصّك: ⁨%1⁩</numerusform>
            <numerusform>صُدّر دون %n ملف يخصّك: ⁨%1⁩</numerusform>
        </translation>
    </message>
    <message>
        <source>In %1 students are told what checks saw, and not which law is wrong.</source>
        <translation>في ⁨%1⁩ يقرأ الطلاب ما رأته الفحوص لا أيّ قانون هو الخطأ.</translation>
    </message>
    <message>
        <source>Export the lab as one file</source>
        <translation>تصدير المختبر ملفًا واحدًا</translation>
    </message>
    <message>
        <source>Exported: %1</source>
        <translation>صُدِّر: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorFiles</name>
    <message>
        <source>New lab</source>
        <translation>مختبر جديد</translation>
    </message>
    <message>
        <source>Title of the lab:</source>
        <translation>عنوان المختبر:</translation>
    </message>
    <message>
        <source>My lab</source>
        <translation>مختبري</translation>
    </message>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation>فتح مجلد مختبر</translation>
    </message>
    <message>
        <source>Open a lab in one file</source>
        <translation>فتح مختبر في ملف واحد</translation>
    </message>
    <message>
        <source>Labs (*.cradle);;All files (*)</source>
        <translation>مختبرات (*.cradle);;كل الملفات (*)</translation>
    </message>
    <message>
        <source>Replace with mine</source>
        <translation>الاستبدال بما عندي</translation>
    </message>
    <message>
        <source>Take theirs</source>
        <translation>أخذ ما عندهم</translation>
    </message>
    <message>
        <source>You have changes that are not saved. If you take the files of the folder instead, Undo brings yours back.</source>
        <translation>لديك تغييرات لم تُحفظ. إن أخذت ملفات المجلد بدلًا منها أعادت «تراجع» تغييراتك.</translation>
    </message>
    <message>
        <source>Saved, but for fields that hold no value yet: %1</source>
        <translation>حُفظ، عدا حقول لا تحوي قيمة بعد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>A new or empty folder for the lab</source>
        <translation>مجلد جديد أو فارغ للمختبر</translation>
    </message>
    <message>
        <source>Folder:</source>
        <translation>المجلد:</translation>
    </message>
    <message>
        <source>Drop what was typed?</source>
        <translation>أتُهمل ما كُتب؟</translation>
    </message>
    <message>
        <source>What is typed here is no value yet, and is not in the lab: %1</source>
        <translation>ما كُتب هنا ليس قيمة بعد ولم يدخل المختبر: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Save the lab?</source>
        <translation>هل يُحفظ المختبر؟</translation>
    </message>
    <message>
        <source>The lab has changes that are not saved.</source>
        <translation>في المختبر تغييرات لم تُحفظ.</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorNotices</name>
    <message>
        <source>A scene of the proof, at the moment where it went wrong: %1</source>
        <translation>مشهد من البرهان، عند لحظة حدوث الخطأ: ⁨%1⁩</translation>
    </message>
    <message>
        <source>This lab ships with Cradle and stays as it is. Look around, or make a copy of it and change that.</source>
        <translation>هذا المختبر مرفق مع Cradle ويبقى كما هو. تجوّل فيه، أو اصنع نسخة منه وغيّرها.</translation>
    </message>
    <message>
        <source>Copy to a folder…</source>
        <translation>نسخ إلى مجلد…</translation>
    </message>
    <message>
        <source>Changed by another program: %1</source>
        <translation>غيّره برنامج آخر: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>إعادة التحميل</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>إهمالها</translation>
    </message>
    <message>
        <source>Cradle ended without saving this lab. Your changes of %1 are back; they are not saved yet.</source>
        <translation>انتهى Cradle دون حفظ هذا المختبر. عادت تغييراتك بتاريخ ⁨%1⁩؛ ولم تُحفظ بعد.</translation>
    </message>
    <message>
        <source>Cradle ended before a new lab was saved for the first time.</source>
        <translation>انتهى Cradle قبل أن يُحفظ مختبر جديد أول مرة.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>فتحه</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorWindow</name>
    <message>
        <source>Insert a figure</source>
        <translation>إدراج شكل</translation>
    </message>
    <message>
        <source>The scene at %1 s</source>
        <translation>المشهد عند ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>لم يُحفظ بعد</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>للقراءة فقط</translation>
    </message>
</context>
<context>
    <name>cradle::BrokenFile</name>
    <message>
        <source>Mend %1</source>
        <translation>إصلاح ⁨%1⁩</translation>
    </message>
    <message>
        <source>Until it can be read, nothing else of this step can be edited. Mend it here; the tabs come back by themselves.</source>
        <translation>ما لم يُقرأ الملف لا يمكن تحرير شيء آخر من هذه المرحلة. أصلحه هنا؛ وتعود التبويبات من تلقاء نفسها.</translation>
    </message>
    <message>
        <source>Text of the file that cannot be read</source>
        <translation>نص الملف الذي تتعذر قراءته</translation>
    </message>
    <message>
        <source>Until it can be read, nothing of the lab can be edited. Mend it here; the steps come back by themselves.</source>
        <translation>ما دام لا يمكن قراءته فلا يمكن تحرير شيء من المختبر. أصلحه هنا وتعود المراحل من تلقاء نفسها.</translation>
    </message>
</context>
<context>
    <name>cradle::ChartPane</name>
    <message>
        <source>%1 · %2</source>
        <comment>heading · unit</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 over time</source>
        <translation>⁨%1⁩ مع الزمن</translation>
    </message>
    <message>
        <source>%1 over time, %2</source>
        <translation>⁨%1⁩ مع الزمن، ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>⁦%1 s⁩</translation>
    </message>
    <message>
        <source>Show the last %1 seconds</source>
        <translation>عرض آخر ⁨%1⁩ ثانية</translation>
    </message>
    <message>
        <source>all</source>
        <comment>the whole run</comment>
        <translation>الكل</translation>
    </message>
    <message>
        <source>Show the whole run</source>
        <translation>عرض التشغيل كله</translation>
    </message>
    <message>
        <source>time</source>
        <translation>الزمن</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>kept run: curve</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>cradle::ChartPlot</name>
    <message>
        <source>%1: %2</source>
        <comment>curve, value</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>cradle::CheckEditor</name>
    <message>
        <source>What is checked</source>
        <translation>ما الذي يُفحص</translation>
    </message>
    <message>
        <source>In which scenes</source>
        <translation>في أي مشاهد</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>العنوان</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>المعرّف</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>النقاط</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>النوع</translation>
    </message>
    <message>
        <source>Title of the check</source>
        <translation>عنوان الفحص</translation>
    </message>
    <message>
        <source>Id of the check</source>
        <translation>معرّف الفحص</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes; reports name the check by it</source>
        <translation>أحرف لاتينية وأرقام ونقاط وشرطات؛ به تسمّي التقارير الفحص</translation>
    </message>
    <message>
        <source>What passing this check is worth in reports</source>
        <translation>قيمة اجتياز هذا الفحص في التقارير</translation>
    </message>
    <message>
        <source>Kind of the check</source>
        <translation>نوع الفحص</translation>
    </message>
</context>
<context>
    <name>cradle::CheckProgram</name>
    <message>
        <source>-- Returns true, or false and what is wrong.
</source>
        <translation>-- تعيد true، أو false وما الخطأ.
</translation>
    </message>
    <message>
        <source>Edit the program of a check</source>
        <translation>تحرير برنامج فحص</translation>
    </message>
    <message>
        <source>Program of the check</source>
        <translation>برنامج الفحص</translation>
    </message>
</context>
<context>
    <name>cradle::CheckRow</name>
    <message>
        <source>Show the moment ▸</source>
        <translation>عرض اللحظة ◂</translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation>عرض اللحظة</translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation>اجتاز: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>أخفق: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Show what was observed</source>
        <translation>عرض ما لوحظ</translation>
    </message>
    <message>
        <source>Show what was observed: %1</source>
        <translation>عرض ما لوحظ: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::CheckTrial</name>
    <message>
        <source>It cannot be tried before what is wrong in this step is mended.</source>
        <translation>لا يمكن تجربته قبل إصلاح ما هو خطأ في هذه المرحلة.</translation>
    </message>
    <message>
        <source>Running…</source>
        <translation>يعمل…</translation>
    </message>
    <message>
        <source>%1 stops in line %2: %3</source>
        <translation>⁨%1⁩ يتوقف في السطر ⁨%2⁩: ⁨%3⁩</translation>
    </message>
    <message>
        <source>%1 stops: %2</source>
        <translation>⁨%1⁩ يتوقف: ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1 passes.</source>
        <translation>⁨%1⁩ يجتاز.</translation>
    </message>
    <message>
        <source>%1 fails: %2</source>
        <translation>⁨%1⁩ يخفق: ⁨%2⁩</translation>
    </message>
    <message>
        <source>Try this check</source>
        <translation>جرّب هذا الفحص</translation>
    </message>
    <message>
        <source>On that program, with the first seed</source>
        <translation>على ذلك البرنامج، بالبذرة الأولى</translation>
    </message>
    <message>
        <source>Program to try the check on</source>
        <translation>البرنامج الذي يُجرَّب عليه الفحص</translation>
    </message>
    <message>
        <source>How the check went</source>
        <translation>كيف جرى الفحص</translation>
    </message>
    <message>
        <source>This is the check as it was before: a field of it holds what is no value.</source>
        <translation>هذا هو الفحص كما كان من قبل: في أحد حقوله ما ليس قيمة.</translation>
    </message>
</context>
<context>
    <name>cradle::ChecksTab</name>
    <message>
        <source>Checks · %1</source>
        <translation>الفحوص · ⁨%1⁩</translation>
    </message>
    <message>
        <source>Edit a check</source>
        <translation>تحرير فحص</translation>
    </message>
    <message>
        <source>New check</source>
        <translation>فحص جديد</translation>
    </message>
    <message>
        <source>Add a check</source>
        <translation>إضافة فحص</translation>
    </message>
    <message>
        <source>Duplicate a check</source>
        <translation>تكرار فحص</translation>
    </message>
    <message>
        <source>Remove a check</source>
        <translation>إزالة فحص</translation>
    </message>
    <message>
        <source>Move a check</source>
        <translation>نقل فحص</translation>
    </message>
    <message>
        <source>Checks of the step</source>
        <translation>فحوص المرحلة</translation>
    </message>
    <message>
        <source>No check yet. Add one with the plus, then say what is right.</source>
        <translation>لا فحص بعد. أضف واحدًا بعلامة الزائد، ثم قل ما الصواب.</translation>
    </message>
    <message>
        <source>Duplicate the check</source>
        <translation>تكرار الفحص</translation>
    </message>
    <message>
        <source>Remove the check</source>
        <translation>إزالة الفحص</translation>
    </message>
    <message>
        <source>Move the check up</source>
        <translation>نقل الفحص إلى أعلى</translation>
    </message>
    <message>
        <source>Move the check down</source>
        <translation>نقل الفحص إلى أسفل</translation>
    </message>
</context>
<context>
    <name>cradle::CircleTableModel</name>
    <message>
        <source>Colour</source>
        <translation>اللون</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>الاسم</translation>
    </message>
    <message>
        <source>Centre, to the right</source>
        <translation>المركز، نحو اليمين</translation>
    </message>
    <message>
        <source>Centre, upward</source>
        <translation>المركز، نحو الأعلى</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>السرعة نحو اليمين</translation>
    </message>
    <message>
        <source>Velocity upward</source>
        <translation>السرعة نحو الأعلى</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>نصف القطر</translation>
    </message>
    <message>
        <source>Density in 1000 kg/m³; steel has 7.8</source>
        <translation>الكثافة بوحدة ⁦1000 kg/m³⁩؛ للفولاذ 7.8</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>الكثافة</translation>
    </message>
    <message>
        <source>How position and velocity are carried over a timestep</source>
        <translation>كيف يُنقل الموضع والسرعة عبر خطوة زمنية</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>طريقة التكامل</translation>
    </message>
    <message>
        <source>Mass of a ball of this radius and density</source>
        <translation>كتلة كرة بنصف القطر والكثافة هذين</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>الكتلة</translation>
    </message>
    <message>
        <source>Change colour of %1</source>
        <translation>تغيير لون ⁨%1⁩</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>إعادة تسمية ⁨%1⁩</translation>
    </message>
    <message>
        <source>Change position of %1</source>
        <translation>تغيير موضع ⁨%1⁩</translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation>تغيير سرعة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Change radius of %1</source>
        <translation>تغيير نصف قطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>Change density of %1</source>
        <translation>تغيير كثافة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Change integrator of %1</source>
        <translation>تغيير طريقة تكامل ⁨%1⁩</translation>
    </message>
    <message>
        <source>Integr.</source>
        <comment>short for Integrator</comment>
        <translation>التكامل</translation>
    </message>
</context>
<context>
    <name>cradle::CirclesGroup</name>
    <message>
        <source>Circles</source>
        <translation>الدوائر</translation>
    </message>
    <message>
        <source>Add circle</source>
        <translation>إضافة دائرة</translation>
    </message>
    <message>
        <source>Add a circle at a free place</source>
        <translation>إضافة دائرة في موضع خالٍ</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>تكرار</translation>
    </message>
    <message>
        <source>Add a copy of the selected circle</source>
        <translation>إضافة نسخة من الدائرة المحددة</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>إزالة</translation>
    </message>
    <message>
        <source>Remove the selected circle (Delete)</source>
        <translation>إزالة الدائرة المحددة ⁦(Delete)⁩</translation>
    </message>
    <message>
        <source>Reset to the step&apos;s scene</source>
        <translation>العودة إلى مشهد المرحلة</translation>
    </message>
    <message>
        <source>Bring back the scene that the step came with; Undo takes it back</source>
        <translation>إرجاع المشهد الذي جاءت به المرحلة؛ و«تراجع» يلغي ذلك</translation>
    </message>
    <message>
        <source>Duplicate circle</source>
        <translation>تكرار دائرة</translation>
    </message>
    <message>
        <source>Remove circle</source>
        <translation>إزالة دائرة</translation>
    </message>
</context>
<context>
    <name>cradle::CirclesLine</name>
    <message>
        <source>Circles: numbers from 1 to 100 as “1, 2” are right</source>
        <translation>الدوائر: الصواب أعداد من 1 إلى 100 مثل «⁦1, 2⁩»</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>الدوائر</translation>
    </message>
    <message>
        <source>Circles that it looks at</source>
        <translation>الدوائر التي ينظر فيها</translation>
    </message>
    <message>
        <source>Numbers of the circles, as “1, 2”</source>
        <translation>أرقام الدوائر، مثل «⁦1, 2⁩»</translation>
    </message>
</context>
<context>
    <name>cradle::ClipboardActions</name>
    <message>
        <source>Cu&amp;t</source>
        <translation>قص (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>نسخ (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>لصق (&amp;P)</translation>
    </message>
    <message>
        <source>Select a&amp;ll</source>
        <translation>تحديد الكل (&amp;A)</translation>
    </message>
</context>
<context>
    <name>cradle::CodeActions</name>
    <message>
        <source>Run code</source>
        <translation>تشغيل البرنامج</translation>
    </message>
    <message>
        <source>Run the program as it stands now, from the start</source>
        <translation>تشغيل البرنامج كما هو الآن، من البداية</translation>
    </message>
    <message>
        <source>Step into line</source>
        <translation>الدخول إلى السطر</translation>
    </message>
    <message>
        <source>Run one line of the program</source>
        <translation>تنفيذ سطر واحد من البرنامج</translation>
    </message>
    <message>
        <source>Finish step</source>
        <translation>إكمال الخطوة</translation>
    </message>
    <message>
        <source>Run the rest of this step</source>
        <translation>تنفيذ بقية هذه الخطوة</translation>
    </message>
    <message>
        <source>Start this step afresh…</source>
        <translation>بدء هذه المرحلة من جديد…</translation>
    </message>
    <message>
        <source>Go back to the program that this step begins with</source>
        <translation>العودة إلى البرنامج الذي تبدأ به هذه المرحلة</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>مرجع اللغة</translation>
    </message>
    <message>
        <source>What the program may use</source>
        <translation>ما يجوز للبرنامج استعماله</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>بحث…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>استبدال…</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>بحث عن التالي</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>بحث عن السابق</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>نص أكبر</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>نص أصغر</translation>
    </message>
    <message>
        <source>Usual text size</source>
        <translation>حجم النص المعتاد</translation>
    </message>
    <message>
        <source>Hide the reference solution</source>
        <translation>إخفاء الحل المرجعي</translation>
    </message>
    <message>
        <source>Show the reference solution</source>
        <translation>عرض الحل المرجعي</translation>
    </message>
    <message>
        <source>A program that passes this step, beside yours</source>
        <translation>برنامج يجتاز هذه المرحلة، إلى جانب برنامجك</translation>
    </message>
    <message>
        <source>After you have passed this step, or opened all its hints</source>
        <translation>بعد أن تجتاز هذه المرحلة، أو تفتح كل تلميحاتها</translation>
    </message>
</context>
<context>
    <name>cradle::CodeDesk</name>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>في الخطوة ⁨%1⁩، عند ⁦%2 s⁩</translation>
    </message>
    <message>
        <source>Reference of the lab&apos;s Lua</source>
        <translation>مرجع لغة Lua في المختبر</translation>
    </message>
    <message>
        <source>Start this step afresh</source>
        <translation>بدء هذه المرحلة من جديد</translation>
    </message>
    <message>
        <source>Your program goes back to what this step started from. What you have written in this step stays among its versions. Go back?</source>
        <translation>يعود برنامجك إلى ما بدأت منه هذه المرحلة. ويبقى ما كتبته فيها بين نسخها. هل تعود؟</translation>
    </message>
</context>
<context>
    <name>cradle::CodeEditor</name>
    <message>
        <source>Undo</source>
        <translation>تراجع</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>إعادة</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>قص</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>نسخ</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>لصق</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>تحديد الكل</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>مرجع اللغة</translation>
    </message>
    <message>
        <source>API reference on %1</source>
        <translation>المرجع عن ⁨%1⁩</translation>
    </message>
    <message>
        <source>Error in line %1: %2</source>
        <translation>خطأ في السطر ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>Line %1 made the first failing step</source>
        <translation>السطر ⁨%1⁩ صنع أول خطوة مخفقة</translation>
    </message>
    <message>
        <source>Line %1 runs next</source>
        <translation>السطر ⁨%1⁩ يُنفَّذ تاليًا</translation>
    </message>
    <message>
        <source>Tab indents; Ctrl+Tab, or Escape and then Tab, leaves the editor</source>
        <translation>المفتاح Tab يزيح؛ و⁦Ctrl+Tab⁩، أو Escape ثم Tab، يغادر المحرر</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>البرنامج</translation>
    </message>
</context>
<context>
    <name>cradle::CodeHeader</name>
    <message>
        <source>Run as I type</source>
        <translation>تشغيل أثناء الكتابة</translation>
    </message>
    <message>
        <source>Run every change at once, as long as the program parses</source>
        <translation>تشغيل كل تغيير فورًا، ما دام البرنامج صحيح النحو</translation>
    </message>
    <message>
        <source>More</source>
        <translation>المزيد</translation>
    </message>
    <message>
        <source>More for the program</source>
        <translation>المزيد للبرنامج</translation>
    </message>
</context>
<context>
    <name>cradle::CodePane</name>
    <message>
        <source>saved</source>
        <translation>محفوظ</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>غير محفوظ</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>للقراءة فقط</translation>
    </message>
    <message>
        <source>cannot be read: the last good version runs</source>
        <translation>تتعذر قراءته: تعمل آخر نسخة سليمة</translation>
    </message>
    <message>
        <source>cannot be read: nothing runs</source>
        <translation>تتعذر قراءته: لا شيء يعمل</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>البرنامج</translation>
    </message>
</context>
<context>
    <name>cradle::CompletionPopup</name>
    <message>
        <source>Completions</source>
        <translation>إكمالات</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleDelegate</name>
    <message>
        <source>load</source>
        <comment>printed while loading</comment>
        <translation>تحميل</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleModel</name>
    <message>
        <source>step %1: %2</source>
        <translation>الخطوة ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>Printed in step %1</source>
        <translation>طُبع في الخطوة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Printed while the program was loaded</source>
        <translation>طُبع أثناء تحميل البرنامج</translation>
    </message>
    <message>
        <source>Printed in step %1, at %2 s; a double click shows it</source>
        <translation>طُبع في الخطوة ⁨%1⁩، عند ⁦%2 s⁩؛ نقرة مزدوجة تعرضها</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleView</name>
    <message>
        <source>Console</source>
        <translation>وحدة الإخراج</translation>
    </message>
    <message>
        <source>print(…) in your program writes here</source>
        <translation>⁦print(…)⁩ في برنامجك تكتب هنا</translation>
    </message>
    <message>
        <source>Lines that the program has printed</source>
        <translation>الأسطر التي طبعها البرنامج</translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation>عرض اللحظة</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>نسخ</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>نسخ الكل</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>مسح</translation>
    </message>
</context>
<context>
    <name>cradle::DifferenceDialog</name>
    <message>
        <source>(not in mine)</source>
        <translation>(ليس في ما عندي)</translation>
    </message>
    <message>
        <source>(not in theirs)</source>
        <translation>(ليس في ما عندهم)</translation>
    </message>
    <message>
        <source>no text</source>
        <translation>لا نص</translation>
    </message>
    <message>
        <source>Changed by another program</source>
        <translation>غيّره برنامج آخر</translation>
    </message>
    <message>
        <source>From mine (−) to theirs (+):</source>
        <translation>مما عندي (−) إلى ما عندهم (+):</translation>
    </message>
    <message>
        <source>Difference of the two versions</source>
        <translation>الفرق بين النسختين</translation>
    </message>
</context>
<context>
    <name>cradle::EnergyChart</name>
    <message>
        <source>By the pro&amp;gram</source>
        <translation>بفعل البرنامج (&amp;G)</translation>
    </message>
    <message>
        <source>Energy made by the program besides the hits, or lost if negative: total + dissipated in hits − total at the start.</source>
        <translation>الطاقة التي صنعها البرنامج غير التصادمات، أو فُقدت إن كانت سالبة: الكلية + المبدَّدة في التصادمات − الكلية في البداية.</translation>
    </message>
    <message>
        <source>By the &amp;integrator</source>
        <translation>بفعل طريقة التكامل (&amp;I)</translation>
    </message>
    <message>
        <source>Energy made by the integrator, or lost if negative: total + dissipated in hits − total at the start. So start = total + dissipated − made by the integrator.</source>
        <translation>الطاقة التي صنعتها طريقة التكامل، أو فُقدت إن كانت سالبة: الكلية + المبدَّدة في التصادمات − الكلية في البداية. أي إن البداية = الكلية + المبدَّدة − ما صنعته طريقة التكامل.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>الطاقة</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>Press Run to see the energy</source>
        <translation>اضغط «تشغيل» لترى الطاقة</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>المنحنيات</translation>
    </message>
    <message>
        <source>Choose the curves</source>
        <translation>اختيار المنحنيات</translation>
    </message>
    <message>
        <source>&amp;Total</source>
        <translation>الكلية (&amp;T)</translation>
    </message>
    <message>
        <source>Total of e&amp;ach</source>
        <translation>الكلية، كل دائرة (&amp;A)</translation>
    </message>
    <message>
        <source>Kinetic, &amp;each circle</source>
        <translation>الحركية، كل دائرة (&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Kinetic, all circles</source>
        <translation>الحركية، كل الدوائر (&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Potential</source>
        <translation>الكامنة (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Dissipated in hits</source>
        <translation>المبدَّدة في التصادمات (&amp;D)</translation>
    </message>
    <message>
        <source>Energy that circles lose in steps with a hit, and while they rest on something; negative if hits made energy, as going back to a higher place does</source>
        <translation>الطاقة التي تفقدها الدوائر في خطوات فيها تصادم، وأثناء استقرارها على شيء؛ سالبة إن صنعت التصادمات طاقة، كما يفعل الرجوع إلى موضع أعلى</translation>
    </message>
    <message>
        <source>More than the e&amp;xact motion</source>
        <translation>الزيادة على الحركة الدقيقة (&amp;X)</translation>
    </message>
    <message>
        <source>Total energy of the run minus that of the exact motion beside it: the error of integrator and timestep</source>
        <translation>الطاقة الكلية للتشغيل ناقص طاقة الحركة الدقيقة إلى جانبه: خطأ طريقة التكامل والخطوة الزمنية</translation>
    </message>
    <message>
        <source>&amp;Stacked areas</source>
        <translation>مساحات متراكمة (&amp;S)</translation>
    </message>
    <message>
        <source>Kinetic, potential and dissipated energy on top of each other</source>
        <translation>الطاقة الحركية والكامنة والمبدَّدة بعضها فوق بعض</translation>
    </message>
    <message>
        <source>more than exact</source>
        <translation>الزيادة على الدقيقة</translation>
    </message>
    <message>
        <source>kinetic %1</source>
        <comment>unit</comment>
        <translation>الحركية %1</translation>
    </message>
    <message>
        <source>kinetic %1</source>
        <translation>الحركية %1</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>الحركية</translation>
    </message>
    <message>
        <source>+ potential</source>
        <translation>+ الكامنة</translation>
    </message>
    <message>
        <source>+ dissipated</source>
        <translation>+ المبدَّدة</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>الكامنة</translation>
    </message>
    <message>
        <source>total</source>
        <translation>الكلية</translation>
    </message>
    <message>
        <source>total %1</source>
        <translation>الكلية %1</translation>
    </message>
    <message>
        <source>taken by hits</source>
        <translation>ما أخذته التصادمات</translation>
    </message>
    <message>
        <source>dissipated</source>
        <translation>المبدَّدة</translation>
    </message>
    <message>
        <source>by the program</source>
        <translation>بفعل البرنامج</translation>
    </message>
    <message>
        <source>by the integrator</source>
        <translation>بفعل طريقة التكامل</translation>
    </message>
</context>
<context>
    <name>cradle::ErrorLine</name>
    <message>
        <source>line %1, step %2: %3</source>
        <translation>السطر ⁨%1⁩، الخطوة ⁨%2⁩: ⁨%3⁩</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>السطر ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation>الخطوة ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>The program stopped: %1</source>
        <translation>توقف البرنامج: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::FindBar</name>
    <message>
        <source>Find</source>
        <translation>بحث</translation>
    </message>
    <message>
        <source>Replace by</source>
        <translation>استبدال بـ</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>مطابقة حالة الأحرف</translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation>كلمات كاملة فقط</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>المطابقة السابقة</translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation>Shift+F3</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>المطابقة التالية</translation>
    </message>
    <message>
        <source>F3</source>
        <translation>F3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>إغلاق</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>استبدال</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>استبدال الكل</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>لم يُستبدل شيء</numerusform>
            <numerusform>استُبدل موضع واحد</numerusform>
            <numerusform>استُبدل موضعان</numerusform>
            <numerusform>استُبدلت %n مواضع</numerusform>
            <numerusform>استُبدل %n موضعًا</numerusform>
            <numerusform>استُبدل %n موضع</numerusform>
        </translation>
    </message>
    <message>
        <source>no match</source>
        <translation>لا مطابقة</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message numerus="yes">
        <source>%n match(es)</source>
        <translation>
            <numerusform>لا مطابقات</numerusform>
            <numerusform>مطابقة واحدة</numerusform>
            <numerusform>مطابقتان</numerusform>
            <numerusform>%n مطابقات</numerusform>
            <numerusform>%n مطابقة</numerusform>
            <numerusform>%n مطابقة</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::FindPanel</name>
    <message>
        <source>Found nowhere</source>
        <translation>لم يوجد في أي مكان</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>لا مواضع</numerusform>
            <numerusform>موضع واحد</numerusform>
            <numerusform>موضعان</numerusform>
            <numerusform>%n مواضع</numerusform>
            <numerusform>%n موضعًا</numerusform>
            <numerusform>%n موضع</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n file(s)</source>
        <translation>
            <numerusform>لا في أي ملف</numerusform>
            <numerusform>في ملف واحد</numerusform>
            <numerusform>في ملفين</numerusform>
            <numerusform>في %n ملفات</numerusform>
            <numerusform>في %n ملفًا</numerusform>
            <numerusform>في %n ملف</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace “%1”</source>
        <translation>استبدال «⁨%1⁩»</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced; Undo brings them back</source>
        <translation>
            <numerusform>لم يُستبدل شيء</numerusform>
            <numerusform>استُبدل موضع واحد؛ والتراجع يعيده</numerusform>
            <numerusform>استُبدل موضعان؛ والتراجع يعيدهما</numerusform>
            <numerusform>استُبدلت %n مواضع؛ والتراجع يعيدها</numerusform>
            <numerusform>استُبدل %n موضعًا؛ والتراجع يعيدها</numerusform>
            <numerusform>استُبدل %n موضع؛ والتراجع يعيدها</numerusform>
        </translation>
    </message>
    <message>
        <source>Find</source>
        <translation>بحث</translation>
    </message>
    <message>
        <source>Text to find in the lab</source>
        <translation>النص المطلوب في المختبر</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>استبدال بـ</translation>
    </message>
    <message>
        <source>Text to put there</source>
        <translation>النص الذي يوضع مكانه</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>استبدال الكل</translation>
    </message>
    <message>
        <source>In all places of the list, as one edit</source>
        <translation>في كل مواضع القائمة، كتعديل واحد</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>مطابقة حالة الأحرف</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>كلمات كاملة</translation>
    </message>
    <message>
        <source>In the whole lab</source>
        <translation>في المختبر كله</translation>
    </message>
    <message>
        <source>In this step</source>
        <translation>في هذه المرحلة</translation>
    </message>
    <message>
        <source>Where to look</source>
        <translation>أين يُبحث</translation>
    </message>
    <message>
        <source>Close the search</source>
        <translation>إغلاق البحث</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Places that were found</source>
        <translation>المواضع التي وُجدت</translation>
    </message>
</context>
<context>
    <name>cradle::FindingCard</name>
    <message>
        <source>Show what was measured</source>
        <translation>عرض ما قيس</translation>
    </message>
    <message>
        <source>Show what was measured: %1</source>
        <translation>عرض ما قيس: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::FindingsList</name>
    <message>
        <source>All files can be read</source>
        <translation>يمكن قراءة كل الملفات</translation>
    </message>
    <message>
        <source>Findings · %1</source>
        <translation>التنبيهات · ⁨%1⁩</translation>
    </message>
    <message>
        <source>Findings in the lab&apos;s files</source>
        <translation>تنبيهات على ملفات المختبر</translation>
    </message>
</context>
<context>
    <name>cradle::FormulaRenderer</name>
    <message>
        <source>Cradle was built without MathJax, so formulas show as text.</source>
        <translation>بُني Cradle دون MathJax، فتظهر الصيغ نصًّا.</translation>
    </message>
    <message>
        <source>MathJax does not run: %1</source>
        <translation>لا يعمل MathJax: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::GradeDialog</name>
    <message>
        <source>Grade a class: %1</source>
        <translation>تقييم صف: ⁨%1⁩</translation>
    </message>
    <message>
        <source>&amp;Handed in:</source>
        <translation>ما سُلِّم (&amp;H):</translation>
    </message>
    <message>
        <source>A folder with a folder, or a .cradle-work file, for each student; or a download of Moodle, Canvas, Blackboard or GitHub Classroom. Nothing in it is changed.</source>
        <translation>مجلد فيه مجلد، أو ملف ⁦.cradle-work⁩، لكل طالب؛ أو تنزيل من Moodle أو Canvas أو Blackboard أو ⁦GitHub Classroom⁩. لا يُغيَّر فيه شيء.</translation>
    </message>
    <message>
        <source>Choose what was handed in</source>
        <translation>اختيار ما سُلِّم</translation>
    </message>
    <message>
        <source>&amp;Results:</source>
        <translation>النتائج (&amp;R):</translation>
    </message>
    <message>
        <source>A folder for the results: an empty one, or one with the results of the same class, which then go on where they were.</source>
        <translation>مجلد للنتائج: فارغ، أو فيه نتائج الصف نفسه، فتواصل من حيث كانت.</translation>
    </message>
    <message>
        <source>Choose a folder for the results</source>
        <translation>اختيار مجلد للنتائج</translation>
    </message>
    <message>
        <source>R&amp;oster:</source>
        <translation>قائمة الصف (&amp;O):</translation>
    </message>
    <message>
        <source>A table (CSV) of who is in the class: id, folder, name, number, email, late days. It may be left out.</source>
        <translation>جدول ⁦(CSV)⁩ بمن في الصف: id وfolder وname وnumber وemail و⁦late days⁩. يجوز تركه.</translation>
    </message>
    <message>
        <source>Choose a roster</source>
        <translation>اختيار قائمة صف</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>جداول (*.csv)</translation>
    </message>
    <message>
        <source> % a day</source>
        <translation> % في اليوم</translation>
    </message>
    <message>
        <source>What each day late that has begun takes of the points</source>
        <translation>ما يأخذه كل يوم تأخير بدأ من النقاط</translation>
    </message>
    <message>
        <source>&amp;Late:</source>
        <translation>التأخير (&amp;L):</translation>
    </message>
    <message>
        <source>How the grading goes</source>
        <translation>كيف يسير التقييم</translation>
    </message>
    <message>
        <source>Students done</source>
        <translation>الطلاب المنجَزون</translation>
    </message>
    <message>
        <source>&amp;Grade</source>
        <translation>تقييم (&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>إيقاف (&amp;S)</translation>
    </message>
    <message>
        <source>O&amp;pen the results</source>
        <translation>فتح النتائج (&amp;P)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>اختيار…</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>اختيار: ⁨%1⁩</translation>
    </message>
    <message>
        <source>What was handed in is read…</source>
        <translation>يُقرأ ما سُلِّم…</translation>
    </message>
    <message>
        <source>%1 of %2 students: %3 steps pass, %4 do not, %5 could not be graded.</source>
        <translation>الطلاب: ⁨%1⁩ من ⁨%2⁩؛ المراحل: اجتيزت ⁨%3⁩، لم تُجتز ⁨%4⁩، تعذّر تقييم ⁨%5⁩.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the students as they were before.</source>
        <translation>
            <numerusform>لا أحد من الطلاب كما كان من قبل.</numerusform>
            <numerusform>طالب واحد كما كان من قبل.</numerusform>
            <numerusform>طالبان كما كانا من قبل.</numerusform>
            <numerusform>%n طلاب كما كانوا من قبل.</numerusform>
            <numerusform>%n طالبًا كما كانوا من قبل.</numerusform>
            <numerusform>%n طالب كما كانوا من قبل.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped. What is judged stays; grading again goes on from here.</source>
        <translation>أُوقف. يبقى ما حُكم عليه؛ والتقييم من جديد يواصل من هنا.</translation>
    </message>
    <message>
        <source>No program opened the page. It is %1</source>
        <translation>لم يفتح أي برنامج الصفحة. هي ⁨%1⁩</translation>
    </message>
    <message>
        <source>Choose what was handed in, and a folder for the results. Grading can be stopped at any time, and goes on where it was.</source>
        <translation>اختر ما سُلِّم، ومجلدًا للنتائج. يمكن إيقاف التقييم في أي وقت، ثم يتابع من حيث توقف.</translation>
    </message>
    <message>
        <source>Remarks on what was handed in</source>
        <translation>ملاحظات على ما سُلِّم</translation>
    </message>
</context>
<context>
    <name>cradle::GradeRun</name>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>لا يمكن بدء ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>cradle-cli broke down</source>
        <translation>انهار ⁦cradle-cli⁩</translation>
    </message>
</context>
<context>
    <name>cradle::HandInDialog</name>
    <message>
        <source>Hand in %1</source>
        <translation>تسليم ⁨%1⁩</translation>
    </message>
    <message>
        <source>The values of this lab were drawn by this number</source>
        <translation>اختيرت قيم هذا المختبر بهذا الرقم</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>المرحلة</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>العنوان</translation>
    </message>
    <message>
        <source>What is handed in</source>
        <translation>ما يُسلَّم</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>الحكم</translation>
    </message>
    <message>
        <source>Steps that are handed in</source>
        <translation>المراحل التي تُسلَّم</translation>
    </message>
    <message>
        <source>Note to the teacher</source>
        <translation>ملاحظة إلى المدرّس</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>الاسم (&amp;N):</translation>
    </message>
    <message>
        <source>N&amp;umber:</source>
        <translation>الرقم (&amp;U):</translation>
    </message>
    <message>
        <source>Note to the &amp;teacher:</source>
        <translation>ملاحظة إلى المدرّس (&amp;T):</translation>
    </message>
    <message>
        <source>&amp;Save the file…</source>
        <translation>حفظ الملف (&amp;S)…</translation>
    </message>
    <message>
        <source>Every step is judged once more…</source>
        <translation>يُحكم على كل مرحلة مرة أخرى…</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>لا شيء</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>برنامج</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>مشهد</translation>
    </message>
    <message>
        <source>passes ✓</source>
        <translation>تُجتاز ✓</translation>
    </message>
    <message>
        <source>does not pass</source>
        <translation>لا تُجتاز</translation>
    </message>
    <message>
        <source>stops with an error</source>
        <translation>تتوقف بخطأ</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>لم تُنجز</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass. All of them are handed in as they are.</source>
        <translation>المراحل المجتازة: ⁨%1⁩ من ⁨%2⁩. تُسلَّم كلها كما هي.</translation>
    </message>
    <message>
        <source>Save what is handed in</source>
        <translation>حفظ ما يُسلَّم</translation>
    </message>
    <message>
        <source>Work to hand in (*.cradle-work)</source>
        <translation>عمل للتسليم (*.cradle-work)</translation>
    </message>
</context>
<context>
    <name>cradle::HelpDesk</name>
    <message>
        <source>The step</source>
        <translation>المرحلة</translation>
    </message>
    <message>
        <source>Here stands what to do and why. The dots are the steps of the lab; hints wait below the text.</source>
        <translation>هنا يرد ما تفعله ولماذا. النقاط هي مراحل المختبر؛ والتلميحات تنتظر تحت النص.</translation>
    </message>
    <message>
        <source>Your program</source>
        <translation>برنامجك</translation>
    </message>
    <message>
        <source>The scene in numbers</source>
        <translation>المشهد بالأرقام</translation>
    </message>
    <message>
        <source>You keep one program through all steps. It is saved and runs as you type; F1 explains the word under the cursor.</source>
        <translation>لديك برنامج واحد عبر كل المراحل. يُحفظ ويعمل وأنت تكتب؛ وF1 يشرح الكلمة التي تحت المؤشر.</translation>
    </message>
    <message>
        <source>World, laws and circles: what you change here or by dragging in the scene starts the run anew.</source>
        <translation>العالم والقوانين والدوائر: ما تغيّره هنا أو بالسحب في المشهد يبدأ التشغيل من جديد.</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>المشهد</translation>
    </message>
    <message>
        <source>What your circles do. At a hit, arrows show the parts of the velocities along and across the normal.</source>
        <translation>ما تفعله دوائرك. عند التصادم تُظهر الأسهم مركّبات السرعات على الناظم ومعامدةً له.</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>المخططات</translation>
    </message>
    <message>
        <source>Momentum and energy of the same run. Click where you want the numbers of that moment; every hit is marked.</source>
        <translation>كمية الحركة والطاقة للتشغيل نفسه. انقر حيث تريد أعداد تلك اللحظة؛ وكل تصادم معلَّم.</translation>
    </message>
    <message>
        <source>Any moment again</source>
        <translation>أي لحظة من جديد</translation>
    </message>
    <message>
        <source>Drag to any moment of the run, or press Next hit. Space runs and pauses.</source>
        <translation>اسحب إلى أي لحظة من التشغيل، أو اضغط «التصادم التالي». مفتاح المسافة يشغّل ويوقف مؤقتًا.</translation>
    </message>
    <message>
        <source>Run and check</source>
        <translation>التشغيل والتحقّق</translation>
    </message>
    <message>
        <source>Run to watch; Check when you are done: it says what is right, what is not, and why.</source>
        <translation>«تشغيل» للمشاهدة؛ و«تحقّق» حين تنتهي: يقول ما الصواب وما الخطأ ولماذا.</translation>
    </message>
    <message>
        <source>:/help/lua-for-csharp.md</source>
        <extracomment>The file of the page in your language: docs/lua-for-csharp.LANGUAGE.md, if there is one</extracomment>
        <translation>:/help/lua-for-csharp.ar.md</translation>
    </message>
    <message>
        <source>Lua for C# people</source>
        <translation>‏Lua لمن يعرف ⁦C#⁩</translation>
    </message>
    <message>
        <source>Comment lines, or not</source>
        <translation>جعل الأسطر تعليقات أو لا</translation>
    </message>
    <message>
        <source>Words that fit here</source>
        <translation>الكلمات المناسبة هنا</translation>
    </message>
    <message>
        <source>What the call takes</source>
        <translation>ما يأخذه الاستدعاء</translation>
    </message>
    <message>
        <source>Out of the program</source>
        <translation>الخروج من البرنامج</translation>
    </message>
    <message>
        <source>Esc, then Tab</source>
        <translation>Esc ثم Tab</translation>
    </message>
    <message>
        <source>Select several circles</source>
        <translation>تحديد عدة دوائر</translation>
    </message>
    <message>
        <source>Ctrl+click, Shift+drag, Shift+arrows</source>
        <translation>‏Ctrl + نقر، Shift + سحب، Shift + أسهم</translation>
    </message>
    <message>
        <source>Move what is selected</source>
        <translation>نقل المحدد</translation>
    </message>
    <message>
        <source>drag; Ctrl+arrows, finer with Shift</source>
        <translation>سحب؛ Ctrl + أسهم، وأدق مع Shift</translation>
    </message>
    <message>
        <source>Drag free of the grid</source>
        <translation>السحب دون التقيد بالشبكة</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>التكبير إلى إطار</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>‏Shift + سحب</translation>
    </message>
    <message>
        <source>wheel; values alone with Ctrl</source>
        <translation>العجلة؛ القيم وحدها مع Ctrl</translation>
    </message>
    <message>
        <source>Move along</source>
        <translation>تحريك الجزء المعروض</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>السحب بالزر الأوسط</translation>
    </message>
    <message>
        <source>Reset the zoom</source>
        <translation>إعادة التكبير الأصلي</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>نقر مزدوج</translation>
    </message>
    <message>
        <source>In a chart</source>
        <translation>في مخطط</translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation>إلغاء السحب</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Remove what is selected</source>
        <translation>حذف المحدد</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>تحريك الرؤية</translation>
    </message>
    <message>
        <source>drag on empty space, or the middle button</source>
        <translation>سحب في موضع خالٍ، أو الزر الأوسط</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>تكبير عند المؤشر</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>العجلة</translation>
    </message>
    <message>
        <source>A step back or on</source>
        <translation>خطوة إلى الوراء أو الأمام</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>السهمان الأيسر والأيمن</translation>
    </message>
    <message>
        <source>The hit before or after</source>
        <translation>التصادم السابق أو التالي</translation>
    </message>
    <message>
        <source>PgUp, PgDown</source>
        <translation>‏PgUp، PgDown</translation>
    </message>
    <message>
        <source>Start and end of the run</source>
        <translation>بداية التشغيل ونهايته</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>‏Home، End</translation>
    </message>
    <message>
        <source>From curve to curve of a chart, from bar to bar of the speeds</source>
        <translation>من منحنى إلى منحنى في المخطط، ومن عمود إلى عمود في مخطط السرعات</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>السهمان الأعلى والأسفل</translation>
    </message>
    <message>
        <source>Hear that curve from left to right</source>
        <translation>سماع هذا المنحنى من اليسار إلى اليمين</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Along the dots of the steps, and open</source>
        <translation>على نقاط المراحل، وفتح</translation>
    </message>
    <message>
        <source>Left, Right, Return</source>
        <translation>السهمان الأيسر والأيمن، وEnter</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>في كل مكان</translation>
    </message>
    <message>
        <source>On the timeline and the steps</source>
        <translation>على خط الزمن والمراحل</translation>
    </message>
    <message>
        <source>In the program</source>
        <translation>في البرنامج</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>في المشهد</translation>
    </message>
    <message>
        <source>About Cradle</source>
        <translation>حول Cradle</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Learn how a physics engine works by writing one.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Built with Qt, Lua, QScintilla, MathJax and valijson.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;⁦Cradle %1⁩&lt;/h3&gt;&lt;p&gt;تعلّم كيف يعمل محرّك الفيزياء بأن تكتب واحدًا.&lt;/p&gt;&lt;p&gt;برنامج حر تحت رخصة GNU العمومية العامة، النسخة 3 أو ما بعدها. بُني بـ Qt وLua وQScintilla وMathJax وvalijson.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>cradle::HintsList</name>
    <message>
        <source>A new hint</source>
        <translation>تلميح جديد</translation>
    </message>
    <message>
        <source>Hints, in the order of opening</source>
        <translation>التلميحات، بترتيب فتحها</translation>
    </message>
    <message>
        <source>Add a hint</source>
        <translation>إضافة تلميح</translation>
    </message>
    <message>
        <source>Remove the hint</source>
        <translation>إزالة التلميح</translation>
    </message>
    <message>
        <source>Move the hint up</source>
        <translation>نقل التلميح إلى أعلى</translation>
    </message>
    <message>
        <source>Move the hint down</source>
        <translation>نقل التلميح إلى أسفل</translation>
    </message>
</context>
<context>
    <name>cradle::HitsModel</name>
    <message>
        <source>left wall</source>
        <translation>الجدار الأيسر</translation>
    </message>
    <message>
        <source>right wall</source>
        <translation>الجدار الأيمن</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>الأرضية</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>السقف</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>circle, wall</comment>
        <translation>⁨%1⁩، ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>circle, circle</comment>
        <translation>⁨%1⁩، ⁨%2⁩</translation>
    </message>
    <message>
        <source>Hit %1 at %2 s: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation>التصادم ⁨%1⁩ عند ⁦%2 s⁩: كمية الحركة قبل ⁨%3⁩، بعد ⁨%4⁩، التغير ⁦%5 kg m/s⁩.</translation>
    </message>
    <message>
        <source>Hit %1 at %2 s, circle %6 on the %7: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation>التصادم ⁨%1⁩ عند ⁦%2 s⁩، الدائرة ⁨%6⁩ على ⁨%7⁩: كمية الحركة قبل ⁨%3⁩، بعد ⁨%4⁩، التغير ⁦%5 kg m/s⁩.</translation>
    </message>
    <message>
        <source>Hit %1: circle %2 on the %3, in contact from %4 s to %5 s.</source>
        <translation>التصادم ⁨%1⁩: الدائرة ⁨%2⁩ على ⁨%3⁩، في تلامس من ⁦%4 s⁩ إلى ⁦%5 s⁩.</translation>
    </message>
    <message>
        <source>Hit %1: circles %2 and %3, in contact from %4 s to %5 s.</source>
        <translation>التصادم ⁨%1⁩: الدائرتان ⁨%2⁩ و⁨%3⁩، متلامستان من ⁦%4 s⁩ إلى ⁦%5 s⁩.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>N s</source>
        <translation>N s</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>Momentum (p_x, p_y) of the circles of the hit; p_x alone where there is no p_y</source>
        <translation>كمية حركة دوائر التصادم ⁦(p_x, p_y)⁩؛ وp_x وحدها حيث لا p_y</translation>
    </message>
    <message>
        <source>time</source>
        <translation>الزمن</translation>
    </message>
    <message>
        <source>who</source>
        <translation>مَن</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>دفع</translation>
    </message>
    <message>
        <source>before</source>
        <translation>قبل</translation>
    </message>
    <message>
        <source>after</source>
        <translation>بعد</translation>
    </message>
    <message>
        <source>change</source>
        <translation>التغير</translation>
    </message>
</context>
<context>
    <name>cradle::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>الخصائص</translation>
    </message>
    <message>
        <source>These values are the start of the run.</source>
        <translation>هذه القيم هي بداية التشغيل.</translation>
    </message>
    <message>
        <source>Not possible: %1.</source>
        <translation>غير ممكن: ⁨%1⁩.</translation>
    </message>
    <message>
        <source>“%1” is not a number; 0.5, 1e-3 or 1/240 would be right.</source>
        <translation>«⁨%1⁩» ليس عددًا؛ الصواب مثل 0.5 أو ⁦1e-3⁩ أو ⁦1/240⁩.</translation>
    </message>
</context>
<context>
    <name>cradle::InstructionsPane</name>
    <message>
        <source>Hint %1</source>
        <translation>التلميح ⁨%1⁩</translation>
    </message>
    <message>
        <source>Hint %1 of %2 ▸</source>
        <translation>التلميح ⁨%1⁩ من ⁨%2⁩ ◂</translation>
    </message>
    <message>
        <source>Show hint %1 of %2</source>
        <translation>عرض التلميح ⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>التعليمات</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>التلميحات</translation>
    </message>
</context>
<context>
    <name>cradle::KeysDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>اختصارات لوحة المفاتيح</translation>
    </message>
</context>
<context>
    <name>cradle::LabDialog</name>
    <message>
        <source>A copy of the lab</source>
        <translation>نسخة من المختبر</translation>
    </message>
    <message>
        <source>Properties of the lab</source>
        <translation>خصائص المختبر</translation>
    </message>
    <message>
        <source>The copy is a lab of its own, so it has an id of its own: who has passed a step of the original has not passed that of the copy.</source>
        <translation>النسخة مختبر مستقل، فلها معرّف خاص بها: من اجتاز مرحلة من الأصل لم يجتز مرحلة النسخة.</translation>
    </message>
    <message>
        <source>The progress of students is kept by the id. A corrected lab keeps its id and gets a higher version; a new lab gets a new id.</source>
        <translation>يُحفظ تقدّم الطلاب بالمعرّف. المختبر المصحَّح يحتفظ بمعرّفه وينال نسخة أعلى؛ والمختبر الجديد ينال معرّفًا جديدًا.</translation>
    </message>
    <message>
        <source>Title, %1</source>
        <translation>العنوان، ⁨%1⁩</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes</source>
        <translation>أحرف لاتينية وأرقام ونقاط وشرطات</translation>
    </message>
    <message>
        <source>The language of task.json and instructions.md; texts in others have files of their own</source>
        <translation>لغة ⁦task.json⁩ و⁦instructions.md⁩؛ وللنصوص بلغات أخرى ملفات خاصة</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>النسخة</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>المعرّف</translation>
    </message>
    <message>
        <source>Written in</source>
        <translation>مكتوب باللغة</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>⁨%1⁩ (نسخة)</translation>
    </message>
    <message>
        <source>A title of 1 to 200 characters is right</source>
        <translation>الصواب عنوان من 1 إلى 200 حرف</translation>
    </message>
    <message>
        <source>Another id than that of the original is right</source>
        <translation>الصواب معرّف غير معرّف الأصل</translation>
    </message>
    <message>
        <source>Edit the properties of the lab</source>
        <translation>تحرير خصائص المختبر</translation>
    </message>
</context>
<context>
    <name>cradle::LabDrop</name>
    <message>
        <source>no version</source>
        <translation>بلا نسخة</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>النسخة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Another version</source>
        <translation>نسخة أخرى</translation>
    </message>
    <message>
        <source>“%1” is there already with %2. The file has %3.</source>
        <translation>«⁨%1⁩» موجود بالفعل وفيه ⁨%2⁩. وفي الملف ⁨%3⁩.</translation>
    </message>
    <message>
        <source>Both have one id, so what was passed in one counts as passed in the other.</source>
        <translation>لكليهما معرّف واحد، فما اجتيز في أحدهما يُحسب مجتازًا في الآخر.</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>استبداله</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>الاحتفاظ بكليهما</translation>
    </message>
</context>
<context>
    <name>cradle::LanguageBox</name>
    <message>
        <source>Texts in %1</source>
        <translation>النصوص باللغة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>لغة النصوص</translation>
    </message>
    <message>
        <source>What is typed in any of the tabs, and the titles of steps, are in this language</source>
        <translation>ما يُكتب في أي تبويب، وعناوين المراحل، بهذه اللغة</translation>
    </message>
</context>
<context>
    <name>cradle::LawsGroup</name>
    <message>
        <source>Change law for walls</source>
        <translation>تغيير قانون الجدران</translation>
    </message>
    <message>
        <source>Change law for circles</source>
        <translation>تغيير قانون الدوائر</translation>
    </message>
    <message>
        <source>Change timing</source>
        <translation>تغيير التوقيت</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>القوانين</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>الجدران</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>الدوائر</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>التوقيت</translation>
    </message>
    <message>
        <source>Law: %1</source>
        <translation>القانون: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Circles leave the square unhindered.</source>
        <translation>تغادر الدوائر المربع بلا عائق.</translation>
    </message>
    <message>
        <source>A wall turns the part of the velocity that points into it around, and multiplies it by e.</source>
        <translation>يعكس الجدار مركّبة السرعة المتجهة إليه، ويضربها في e.</translation>
    </message>
    <message>
        <source>Circles pass through each other.</source>
        <translation>تمر الدوائر بعضها عبر بعض.</translation>
    </message>
    <message>
        <source>Circles that meet both stop.</source>
        <translation>الدائرتان اللتان تلتقيان تتوقفان.</translation>
    </message>
    <message>
        <source>Circles that meet exchange their whole velocities.</source>
        <translation>الدائرتان اللتان تلتقيان تتبادلان سرعتيهما كاملتين.</translation>
    </message>
    <message>
        <source>Only the parts of the velocities along the line of centres are exchanged; the parts across it stay.</source>
        <translation>لا تُتبادل إلا مركّبتا السرعتين على خط المركزين؛ وتبقى المعامدتان له.</translation>
    </message>
    <message>
        <source>An impulse along the line of centres keeps the momentum, with the masses and the restitution e.</source>
        <translation>دفع على خط المركزين يحفظ كمية الحركة، بالكتلتين ومعامل الارتداد e.</translation>
    </message>
    <message>
        <source>After each step overlaps are looked for; on a hit the circles go back to their old positions and respond.</source>
        <translation>بعد كل خطوة يُبحث عن التداخلات؛ وعند التصادم تعود الدوائر إلى مواضعها القديمة وتستجيب.</translation>
    </message>
    <message>
        <source>The time of a hit inside the step is found, and the rest of the step is spent after it.</source>
        <translation>يُحسب زمن التصادم داخل الخطوة، ثم يُكمَل باقي الخطوة بعده.</translation>
    </message>
    <message>
        <source>The motion is solved from hit to hit; the timestep only says when to look.</source>
        <translation>تُحل الحركة من تصادم إلى تصادم؛ ولا تحدد الخطوة الزمنية إلا متى يُنظر إليها.</translation>
    </message>
</context>
<context>
    <name>cradle::LocalsTable</name>
    <message>
        <source>Local variables</source>
        <translation>المتغيرات المحلية</translation>
    </message>
    <message>
        <source>None at this line</source>
        <translation>لا شيء عند هذا السطر</translation>
    </message>
    <message>
        <source>Local variables at the line that runs next</source>
        <translation>المتغيرات المحلية عند السطر الذي يُنفَّذ تاليًا</translation>
    </message>
</context>
<context>
    <name>cradle::MarkdownView</name>
    <message>
        <source>(a picture)</source>
        <translation>(صورة)</translation>
    </message>
</context>
<context>
    <name>cradle::MomentumChart</name>
    <message>
        <source>Momentum</source>
        <translation>كمية الحركة</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>Press Run to see the momentum</source>
        <translation>اضغط «تشغيل» لترى كمية الحركة</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>كمية الحركة نحو اليمين</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>كمية الحركة نحو الأعلى</translation>
    </message>
    <message>
        <source>Size of the momentum</source>
        <translation>مقدار كمية الحركة</translation>
    </message>
    <message>
        <source>Part of the momentum</source>
        <translation>مركّبة كمية الحركة</translation>
    </message>
    <message>
        <source>sum %1</source>
        <translation>المجموع ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::NotesPane</name>
    <message>
        <source>Notes</source>
        <translation>ملاحظات</translation>
    </message>
    <message>
        <source>What you noted about this step: it becomes part of your report. Markdown, and formulas as $v = a t$.</source>
        <translation>ما دوّنته عن هذه المرحلة: يصير جزءًا من تقريرك. صيغة Markdown، والصيغ الرياضية مثل ⁦$v = a t$⁩.</translation>
    </message>
    <message>
        <source>Notes about this step</source>
        <translation>ملاحظات عن هذه المرحلة</translation>
    </message>
    <message>
        <source>The notes, set</source>
        <translation>الملاحظات بعد التنسيق</translation>
    </message>
</context>
<context>
    <name>cradle::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>إشعار</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>فهمت</translation>
    </message>
</context>
<context>
    <name>cradle::Opening</name>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation>فتح مجلد مختبر</translation>
    </message>
    <message>
        <source>Open a lab in one file</source>
        <translation>فتح مختبر في ملف واحد</translation>
    </message>
    <message>
        <source>Labs and work (*.cradle *.cradle-work);;All files (*)</source>
        <translation>مختبرات وأعمال (*.cradle *.cradle-work);;كل الملفات (*)</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>فتح مشهد</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>مشاهد (*.json);;كل الملفات (*)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>حفظ المشهد</translation>
    </message>
</context>
<context>
    <name>cradle::OtherMistakesMenu</name>
    <message>
        <source>A mistake of another &amp;step</source>
        <translation>خطأ من مرحلة أخرى (&amp;S)</translation>
    </message>
    <message>
        <source>No mistake of another step applies to this solution that the step does not have</source>
        <translation>لا خطأ في مرحلة أخرى ينطبق على هذا الحل وليس في المرحلة بعد</translation>
    </message>
</context>
<context>
    <name>cradle::ParameterForm</name>
    <message>
        <source>left out</source>
        <translation>متروك</translation>
    </message>
    <message>
        <source>%1 (usual)</source>
        <translation>⁨%1⁩ (المعتاد)</translation>
    </message>
</context>
<context>
    <name>cradle::PhaseChart</name>
    <message>
        <source>Vertical axis: %1</source>
        <translation>المحور الرأسي: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Horizontal axis: %1</source>
        <translation>المحور الأفقي: ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>⁨%1⁩ بدلالة ⁨%2⁩</translation>
    </message>
    <message>
        <source>Press Run to see one quantity against another</source>
        <translation>اضغط «تشغيل» لترى كمية بدلالة أخرى</translation>
    </message>
    <message>
        <source>There is nothing to draw: choose other quantities</source>
        <translation>لا شيء للرسم: اختر كميتين أخريين</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <comment>quantity, unit</comment>
        <translation>⁨%1⁩ بوحدة ⁨%2⁩</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>طور</translation>
    </message>
    <message>
        <source>against</source>
        <translation>بدلالة</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>quantity, unit</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Circle %1</source>
        <translation>الدائرة %1</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>الكل معًا</translation>
    </message>
    <message>
        <source>%1, circle %2</source>
        <comment>quantity, of</comment>
        <translation>⁨%1⁩، الدائرة ⁨%2⁩</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <comment>quantity, value, unit</comment>
        <translation>⁨%1⁩: ⁦%2 %3⁩</translation>
    </message>
</context>
<context>
    <name>cradle::PictureObjects</name>
    <message>
        <source>pictures from elsewhere are not loaded</source>
        <translation>لا تُحمَّل صور من أماكن أخرى</translation>
    </message>
    <message>
        <source>the picture must be in the folder of the instructions</source>
        <translation>يجب أن تكون الصورة في مجلد التعليمات</translation>
    </message>
    <message>
        <source>there is no picture %1</source>
        <translation>لا توجد صورة ⁨%1⁩</translation>
    </message>
    <message>
        <source>the picture cannot be read</source>
        <translation>تتعذر قراءة الصورة</translation>
    </message>
    <message>
        <source>the picture refers to another file</source>
        <translation>تشير الصورة إلى ملف آخر</translation>
    </message>
    <message>
        <source>the picture is too large; at most %1 × %1 pixels are right</source>
        <translation>الصورة كبيرة جدًّا؛ الصواب ⁦%1 × %1⁩ بكسل على الأكثر</translation>
    </message>
</context>
<context>
    <name>cradle::PinnedRuns</name>
    <message>
        <source>pinned %1</source>
        <comment>a run</comment>
        <translation>المثبّت %1</translation>
    </message>
    <message>
        <source>%1: how it went on after %2 s</source>
        <comment>kept run, moment</comment>
        <translation>⁨%1⁩: كيف مضى بعد ⁦%2 s⁩</translation>
    </message>
    <message>
        <source>%1: the same scene and program</source>
        <translation>⁨%1⁩: المشهد والبرنامج نفساهما</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>⁨%1⁩ ولا شيء غيره</numerusform>
            <numerusform>⁨%1⁩ وواحد غيره</numerusform>
            <numerusform>⁨%1⁩ واثنان غيره</numerusform>
            <numerusform>⁨%1⁩ و%n غيره</numerusform>
            <numerusform>⁨%1⁩ و%n غيره</numerusform>
            <numerusform>⁨%1⁩ و%n غيره</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::Plot</name>
    <message>
        <source>%1 %</source>
        <comment>share</comment>
        <translation>⁦%1 %⁩</translation>
    </message>
</context>
<context>
    <name>cradle::PlotPane</name>
    <message>
        <source>Zoom, pin and export</source>
        <translation>تكبير وتثبيت وتصدير</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>تكبير (&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>تصغير (&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Reset zoom</source>
        <translation>إعادة التكبير الأصلي (&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Pin this run</source>
        <translation>تثبيت هذا التشغيل (&amp;P)</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <comment>a kept run</comment>
        <translation>إزالة ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::PlotsChart</name>
    <message>
        <source>Plots</source>
        <translation>رسوم بيانية</translation>
    </message>
    <message>
        <source>plot(name, number) in your program adds a curve here</source>
        <translation>⁦plot(name, number)⁩ في برنامجك تضيف منحنى هنا</translation>
    </message>
</context>
<context>
    <name>cradle::PredictionCard</name>
    <message>
        <source>Not sure</source>
        <translation>لست متأكدًا</translation>
    </message>
    <message>
        <source>The scene has run already. What did you expect?</source>
        <translation>عُرض المشهد بالفعل. ماذا توقعت؟</translation>
    </message>
    <message>
        <source>Choose before you run the scene. The check does not count it.</source>
        <translation>اختر قبل تشغيل المشهد. لا يحسبه التحقّق.</translation>
    </message>
    <message>
        <source>Kept. Did it come so?</source>
        <translation>حُفظ. هل حدث كذلك؟</translation>
    </message>
    <message>
        <source>Kept. Now run the scene and watch.</source>
        <translation>حُفظ. شغّل المشهد الآن وراقب.</translation>
    </message>
    <message>
        <source>You were not sure.</source>
        <translation>لم تكن متأكدًا.</translation>
    </message>
    <message>
        <source>You predicted: %1</source>
        <translation>توقعت: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>توقّع</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>التوقّع</translation>
    </message>
    <message>
        <source>What happens: %1.</source>
        <translation>ما يحدث: ⁨%1⁩.</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>السؤال</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>ما يحدث</translation>
    </message>
    <message>
        <source>Show what happens ▸</source>
        <translation>عرض ما يحدث ◂</translation>
    </message>
    <message>
        <source>Show what happens</source>
        <translation>عرض ما يحدث</translation>
    </message>
</context>
<context>
    <name>cradle::PredictionEditor</name>
    <message>
        <source>What will happen?</source>
        <translation>ماذا سيحدث؟</translation>
    </message>
    <message>
        <source>The first answer</source>
        <translation>الإجابة الأولى</translation>
    </message>
    <message>
        <source>The second answer</source>
        <translation>الإجابة الثانية</translation>
    </message>
    <message>
        <source>What happens, and why.</source>
        <translation>ما يحدث، ولماذا.</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>إجابة أخرى</translation>
    </message>
    <message>
        <source>A question of 1 to %1 characters is right</source>
        <translation>الصواب سؤال من 1 إلى ⁨%1⁩ حرفًا</translation>
    </message>
    <message>
        <source>A text of 1 to %1 characters on what happens is right</source>
        <translation>الصواب نص من 1 إلى ⁨%1⁩ حرفًا عمّا يحدث</translation>
    </message>
    <message>
        <source>An answer of 1 to 100 characters is right</source>
        <translation>الصواب إجابة من 1 إلى 100 حرف</translation>
    </message>
    <message>
        <source>This step asks for no prediction. A question that is asked before the scene is watched, and answered after it, makes students look.</source>
        <translation>لا تطلب هذه المرحلة توقّعًا. السؤال الذي يُطرح قبل مشاهدة المشهد ويُجاب عنه بعدها يجعل الطلاب ينظرون.</translation>
    </message>
    <message>
        <source>Ask for a prediction</source>
        <translation>طلب توقّع</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>السؤال</translation>
    </message>
    <message>
        <source>Answers: two to four that students truly believe; mark the one that comes true</source>
        <translation>الإجابات: من اثنتين إلى أربع يعتقدها الطلاب حقًّا؛ علّم التي تتحقق</translation>
    </message>
    <message>
        <source>Answer %1 comes true</source>
        <translation>تتحقق الإجابة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>الإجابة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Remove answer %1</source>
        <translation>إزالة الإجابة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>إضافة إجابة</translation>
    </message>
    <message>
        <source>What happens, and why; told after the step was passed</source>
        <translation>ما يحدث، ولماذا؛ يُقال بعد اجتياز المرحلة</translation>
    </message>
    <message>
        <source>What happens, and why</source>
        <translation>ما يحدث، ولماذا</translation>
    </message>
    <message>
        <source>Remove the prediction</source>
        <translation>إزالة التوقّع</translation>
    </message>
    <message>
        <source>What the student sees before</source>
        <translation>ما يراه الطالب قبل</translation>
    </message>
    <message>
        <source>And after</source>
        <translation>وبعد</translation>
    </message>
</context>
<context>
    <name>cradle::Presenter</name>
    <message>
        <source>Scene</source>
        <translation>المشهد</translation>
    </message>
</context>
<context>
    <name>cradle::PresetDocument</name>
    <message>
        <source>Start from %1 s</source>
        <translation>البدء من ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>This is a scene of the check; go back to your own scene to change it</source>
        <translation>هذا مشهد من الفحص؛ عد إلى مشهدك لتغييره</translation>
    </message>
    <message>
        <source>Reset to the step&apos;s own scene</source>
        <translation>العودة إلى مشهد المرحلة الخاص</translation>
    </message>
</context>
<context>
    <name>cradle::ProgramPage</name>
    <message>
        <source>Program %1</source>
        <translation>البرنامج ⁨%1⁩</translation>
    </message>
    <message>
        <source>What a student&apos;s program starts from in this step.</source>
        <translation>ما يبدأ منه برنامج الطالب في هذه المرحلة.</translation>
    </message>
    <message>
        <source>None of its own: students go on from the solution of the step before. Write here to start from something else.</source>
        <translation>لا شيء خاص بها: يمضي الطلاب من حل المرحلة السابقة. اكتب هنا للبدء من شيء آخر.</translation>
    </message>
    <message>
        <source>The reference: it should pass every check, with every seed.</source>
        <translation>المرجع: ينبغي أن يجتاز كل فحص، مع كل بذرة.</translation>
    </message>
    <message>
        <source>The solution was changed where this difference changes it. Mend the lines after @@ so that they say what stands in the solution now, and what stands here instead.</source>
        <translation>غُيّر الحل حيث يغيّره هذا الفرق. أصلح الأسطر بعد @@ لتقول ما في الحل الآن، وما يحل هنا محله.</translation>
    </message>
    <message>
        <source>A whole program with one mistake: it fails by a check, and who wrote the same reads the comment that it begins with.</source>
        <translation>برنامج كامل فيه خطأ واحد: يخفق في فحص، ومن كتب مثله يقرأ التعليق البرمجي الذي يبدأ به.</translation>
    </message>
    <message>
        <source>A whole program that passes and deserves a word.</source>
        <translation>برنامج كامل يجتاز ويستحق كلمة.</translation>
    </message>
    <message>
        <source>It is kept as its difference from the solution, which is marked, and follows it.</source>
        <translation>يُحفظ فرقًا عن الحل، والفرق معلَّم، ويتبعه.</translation>
    </message>
    <message>
        <source>Edit a program</source>
        <translation>تحرير برنامج</translation>
    </message>
    <message>
        <source>Edit what the student reads</source>
        <translation>تحرير ما يقرؤه الطالب</translation>
    </message>
    <message>
        <source>Edit a remark</source>
        <translation>تحرير تعقيب</translation>
    </message>
    <message>
        <source>What the student reads</source>
        <translation>ما يقرؤه الطالب</translation>
    </message>
    <message>
        <source>How it is recognised</source>
        <translation>كيف يُتعرَّف عليه</translation>
    </message>
    <message>
        <source>About the program</source>
        <translation>عن البرنامج</translation>
    </message>
    <message>
        <source>The comment that the program begins with, or its translation</source>
        <translation>التعليق البرمجي الذي يبدأ به البرنامج، أو ترجمته</translation>
    </message>
    <message>
        <source>What the student reads, translated</source>
        <translation>ما يقرؤه الطالب، مترجمًا</translation>
    </message>
    <message>
        <source>The starter for students who read %1: the same code, with comments in that language. Without it they get starter.lua.</source>
        <translation>برنامج البداية لمن يقرأ ⁨%1⁩: الشيفرة نفسها بتعليقات بهذه اللغة. ومن دونه يحصلون على ⁦starter.lua⁩.</translation>
    </message>
</context>
<context>
    <name>cradle::ProgramsTab</name>
    <message>
        <source>-- What went wrong, in a few words
--
-- What was observed, what it means, and where to look.
</source>
        <translation>-- ما الخطأ، في كلمات قليلة
--
-- ما لوحظ، وما معناه، وأين يُنظر.
</translation>
    </message>
    <message>
        <source>-- What is good about it, in a few words
--
-- What it does otherwise than most, and what that is worth.
</source>
        <translation>-- ما الجيد فيه، في كلمات قليلة
--
-- ما يفعله على غير ما يفعل أكثر الناس، وما قيمة ذلك.
</translation>
    </message>
    <message>
        <source>Add a mistake</source>
        <translation>إضافة خطأ</translation>
    </message>
    <message>
        <source>Add a remark</source>
        <translation>إضافة تعقيب</translation>
    </message>
    <message>
        <source>Remove a program</source>
        <translation>إزالة برنامج</translation>
    </message>
    <message>
        <source>Rename a program</source>
        <translation>إعادة تسمية برنامج</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>البرامج</translation>
    </message>
    <message>
        <source>Programs of the step</source>
        <translation>برامج المرحلة</translation>
    </message>
    <message>
        <source>Add a program</source>
        <translation>إضافة برنامج</translation>
    </message>
    <message>
        <source>Rename the program</source>
        <translation>إعادة تسمية البرنامج</translation>
    </message>
    <message>
        <source>Remove the program</source>
        <translation>إزالة البرنامج</translation>
    </message>
    <message>
        <source>A &amp;mistake that students make</source>
        <translation>خطأ يرتكبه الطلاب (&amp;M)</translation>
    </message>
    <message>
        <source>A &amp;remark on work that passes</source>
        <translation>تعقيب على عمل يجتاز (&amp;R)</translation>
    </message>
    <message>
        <source>Take over a mistake</source>
        <translation>أخذ خطأ</translation>
    </message>
</context>
<context>
    <name>cradle::ProofMatrix</name>
    <message>
        <source>Programs and the checks that they fail</source>
        <translation>البرامج والفحوص التي تخفق فيها</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>البرنامج</translation>
    </message>
    <message>
        <source>Said of it</source>
        <translation>ما يقال عنه</translation>
    </message>
    <message>
        <source>Check %1</source>
        <translation>الفحص ⁨%1⁩</translation>
    </message>
    <message>
        <source>Just wrong enough</source>
        <translation>خاطئ بالقدر الكافي تمامًا</translation>
    </message>
    <message>
        <source>%1: turned by %2, too fast by %3, adrift by %4</source>
        <translation>⁨%1⁩: بدوران ⁨%2⁩، بزيادة سرعة ⁨%3⁩، بحيود ⁨%4⁩</translation>
    </message>
    <message>
        <source>%1: not measured</source>
        <translation>⁨%1⁩: لم يُقس</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>يجتاز</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>السطر ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>not recognised</source>
        <translation>لم يُتعرَّف عليه</translation>
    </message>
    <message>
        <source>By how much a right run must be turned, too fast or adrift, or how wrong restitution and masses must be in its first hit, for the check to fail it</source>
        <translation>بكم يجب أن يُدار تشغيل صحيح أو يسرع أو ينحرف، أو كم يجب أن يكون معامل الارتداد والكتل خاطئة في تصادمه الأول، حتى يخفق في الفحص</translation>
    </message>
    <message>
        <source>; a hit with %1</source>
        <translation>؛ تصادم مع ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::ProofTab</name>
    <message>
        <source>Every program runs through the checks…</source>
        <translation>يمر كل برنامج على الفحوص…</translation>
    </message>
    <message>
        <source>Press Verify this step: the starter should fail by a check, the solution pass with every seed, and each mistake fail and be recognised.</source>
        <translation>اضغط «تدقيق هذه المرحلة»: ينبغي أن يخفق برنامج البداية في فحص، وأن يجتاز الحل مع كل بذرة، وأن يخفق كل خطأ ويُتعرَّف عليه.</translation>
    </message>
    <message>
        <source>Not as it should be: %1</source>
        <translation>ليس كما ينبغي: ⁨%1⁩</translation>
    </message>
    <message>
        <source>The solution passes, and every mistake fails and is recognised; but a check is missing: changes of the solution that pass every check: %1</source>
        <translation>يجتاز الحل، ويخفق كل خطأ ويُتعرَّف عليه؛ لكن ينقص فحص: تغييرات في الحل تجتاز كل فحص: ⁨%1⁩</translation>
    </message>
    <message>
        <source>All is as it should be: the solution passes, every mistake fails and is recognised, every check is needed.</source>
        <translation>كل شيء كما ينبغي: يجتاز الحل، ويخفق كل خطأ ويُتعرَّف عليه، وكل فحص لازم.</translation>
    </message>
    <message>
        <source>All is as it should be: the solution passes, every mistake fails and is recognised.</source>
        <translation>كل شيء كما ينبغي: يجتاز الحل، ويخفق كل خطأ ويُتعرَّف عليه.</translation>
    </message>
    <message>
        <source>So it is in every step of the lab.</source>
        <translation>وكذلك في كل مرحلة من المختبر.</translation>
    </message>
    <message>
        <source>Not as it should be in other steps: %1</source>
        <translation>ليس كما ينبغي في مراحل أخرى: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>التنبيهات</translation>
    </message>
    <message>
        <source>Worth a look</source>
        <translation>يستحق نظرة</translation>
    </message>
    <message>
        <source>Mistakes that this step does not know</source>
        <translation>أخطاء لا تعرفها هذه المرحلة</translation>
    </message>
    <message>
        <source>Mistakes that this step did not know before the last edits</source>
        <translation>أخطاء لم تكن هذه المرحلة تعرفها قبل آخر تحرير</translation>
    </message>
    <message>
        <source>None was found: each change of the solution is caught and explained.</source>
        <translation>لم يُعثر على شيء: كل تغيير في الحل يُكتشف ويُشرح.</translation>
    </message>
    <message>
        <source>Show the run</source>
        <translation>عرض التشغيل</translation>
    </message>
    <message>
        <source>Open the scene</source>
        <translation>فتح المشهد</translation>
    </message>
    <message>
        <source>Open the program</source>
        <translation>فتح البرنامج</translation>
    </message>
    <message>
        <source>Open the check</source>
        <translation>فتح الفحص</translation>
    </message>
    <message>
        <source>Open the programs</source>
        <translation>فتح البرامج</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>السطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>السطر ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>Passes every check, so one is missing: %1 (%2)</source>
        <translation>يجتاز كل فحص، إذن ينقص واحد: ⁨%1⁩ (⁨%2⁩)</translation>
    </message>
    <message>
        <source>Fails by “%1” without a word on why: %2 (%3)</source>
        <translation>يخفق في «⁨%1⁩» دون كلمة عن السبب: ⁨%2⁩ (⁨%3⁩)</translation>
    </message>
    <message>
        <source>Add as a mistake</source>
        <translation>إضافته خطأً</translation>
    </message>
    <message>
        <source>Add a suggested mistake</source>
        <translation>إضافة خطأ مقترح</translation>
    </message>
    <message>
        <source>Verify this step</source>
        <translation>تدقيق هذه المرحلة</translation>
    </message>
    <message>
        <source>Judges every program of the step, the solution with five seeds</source>
        <translation>يحكم على كل برنامج في المرحلة، وعلى الحل بخمس بذور</translation>
    </message>
    <message>
        <source>Verify the lab</source>
        <translation>تدقيق المختبر</translation>
    </message>
    <message>
        <source>Suggest mistakes</source>
        <translation>اقتراح أخطاء</translation>
    </message>
    <message>
        <source>Changes the solution as students err, and tells which changes the checks miss or cannot explain</source>
        <translation>يغيّر الحل كما يخطئ الطلاب، ويقول أيّ التغييرات تفوت الفحوص أو لا تستطيع شرحها</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>إيقاف</translation>
    </message>
    <message>
        <source>Progress of the proof</source>
        <translation>تقدّم البرهان</translation>
    </message>
    <message>
        <source>The lab was edited since.</source>
        <translation>حُرّر المختبر منذ ذلك الحين.</translation>
    </message>
    <message>
        <source>Fails by “%1”; students read: “%2”, of: %3 (%4)</source>
        <translation>يخفق في «⁨%1⁩»؛ ويقرأ الطلاب «⁨%2⁩»، في: ⁨%3⁩ (⁨%4⁩)</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionField</name>
    <message>
        <source>a number</source>
        <translation>عدد</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>عدد مع وحدته</translation>
    </message>
    <message>
        <source>In a few sentences, for the teacher</source>
        <translation>في بضع جمل، للمدرّس</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>نقل إلى أعلى</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>نقل إلى أسفل</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Down</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionsCard</name>
    <message>
        <source>Questions</source>
        <translation>أسئلة</translation>
    </message>
    <message>
        <source>The check counts your answers.</source>
        <translation>يحسب التحقّق إجاباتك.</translation>
    </message>
    <message>
        <source>%1 (%2 points)</source>
        <translation>⁨%1⁩ (النقاط: ⁨%2⁩)</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionsEditor</name>
    <message>
        <source>Questions · %1</source>
        <translation>الأسئلة · ⁨%1⁩</translation>
    </message>
    <message>
        <source>Answers in the right order; students find them in another</source>
        <translation>الإجابات بالترتيب الصحيح؛ يجدها الطلاب بترتيب آخر</translation>
    </message>
    <message>
        <source>Answers; mark the right one</source>
        <translation>الإجابات؛ علّم الصحيحة</translation>
    </message>
    <message>
        <source>Answers; mark all that are right</source>
        <translation>الإجابات؛ علّم كل الصحيحة</translation>
    </message>
    <message>
        <source>A new question</source>
        <translation>سؤال جديد</translation>
    </message>
    <message>
        <source>What is asked?</source>
        <translation>ما المطلوب؟</translation>
    </message>
    <message>
        <source>The first answer</source>
        <translation>الإجابة الأولى</translation>
    </message>
    <message>
        <source>The second answer</source>
        <translation>الإجابة الثانية</translation>
    </message>
    <message>
        <source>A title of 1 to 200 characters is right</source>
        <translation>الصواب عنوان من 1 إلى 200 حرف</translation>
    </message>
    <message>
        <source>Another question has this id already</source>
        <translation>لسؤال آخر هذا المعرّف بالفعل</translation>
    </message>
    <message>
        <source>Tolerance: a number from 0 is right</source>
        <translation>التفاوت المسموح: الصواب عدد ابتداء من 0</translation>
    </message>
    <message>
        <source>%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right</source>
        <translation>⁨%1⁩ ليست وحدة؛ الصواب مثل ⁦m/s⁩ أو ⁦kg m/s⁩ أو ⁦N s⁩ أو J أو ° أو %</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>إجابة أخرى</translation>
    </message>
    <message>
        <source>Questions of the step</source>
        <translation>أسئلة المرحلة</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>إضافة سؤال</translation>
    </message>
    <message>
        <source>Remove the question</source>
        <translation>إزالة السؤال</translation>
    </message>
    <message>
        <source>Move the question up</source>
        <translation>نقل السؤال إلى أعلى</translation>
    </message>
    <message>
        <source>Move the question down</source>
        <translation>نقل السؤال إلى أسفل</translation>
    </message>
    <message>
        <source>This step asks no question that counts. Add one with the plus: a number with its unit, a choice, an order, or a text that you read yourself.</source>
        <translation>لا تطرح هذه المرحلة سؤالًا يُحسب. أضف واحدًا بعلامة الزائد: عدد مع وحدته، أو اختيار، أو ترتيب، أو نص تقرؤه بنفسك.</translation>
    </message>
    <message>
        <source>A number</source>
        <translation>عدد</translation>
    </message>
    <message>
        <source>One choice</source>
        <translation>اختيار واحد</translation>
    </message>
    <message>
        <source>Several choices</source>
        <translation>عدة اختيارات</translation>
    </message>
    <message>
        <source>An order</source>
        <translation>ترتيب</translation>
    </message>
    <message>
        <source>A text for the teacher</source>
        <translation>نص للمدرّس</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>النوع</translation>
    </message>
    <message>
        <source>Kind of the question</source>
        <translation>نوع السؤال</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>العنوان</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>المعرّف</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>النقاط</translation>
    </message>
    <message>
        <source>Right number</source>
        <translation>العدد المطلوب</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>التفاوت المسموح</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>الوحدة</translation>
    </message>
    <message>
        <source>Reports name the question by it</source>
        <translation>به تسمّي التقارير السؤال</translation>
    </message>
    <message>
        <source>What a right answer is worth; of a text, what you may give</source>
        <translation>قيمة الإجابة الصحيحة؛ وللنص ما يجوز أن تعطيه</translation>
    </message>
    <message>
        <source>A number, or an expression like 2*9.81*5</source>
        <translation>عدد، أو عبارة مثل ⁦2*9.81*5⁩</translation>
    </message>
    <message>
        <source>How far off is still right, in the unit</source>
        <translation>كم يجوز أن يبلغ الفرق ويبقى صحيحًا، بالوحدة</translation>
    </message>
    <message>
        <source>Such as m/s, kg m/s, N s, J, ° or %; answers in other units of the same kind are converted</source>
        <translation>مثل ⁦m/s⁩ أو ⁦kg m/s⁩ أو ⁦N s⁩ أو J أو ° أو %؛ وتُحوَّل الإجابات بوحدات أخرى من النوع نفسه</translation>
    </message>
    <message>
        <source>What is asked</source>
        <translation>ما المطلوب</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>الإجابات</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>إضافة إجابة</translation>
    </message>
    <message>
        <source>Remove the answer</source>
        <translation>إزالة الإجابة</translation>
    </message>
    <message>
        <source>Move the answer up</source>
        <translation>نقل الإجابة إلى أعلى</translation>
    </message>
    <message>
        <source>Move the answer down</source>
        <translation>نقل الإجابة إلى أسفل</translation>
    </message>
    <message>
        <source>What the student sees, answered rightly</source>
        <translation>ما يراه الطالب، بإجابة صحيحة</translation>
    </message>
</context>
<context>
    <name>cradle::RemarkEditor</name>
    <message>
        <source>A student&apos;s program that passes is run beside this one and beside the solution. Where these two differ and the student&apos;s does as this one, the remark is made.</source>
        <translation>يُشغَّل برنامج الطالب الذي يجتاز إلى جانب هذا وإلى جانب الحل. حيث يختلف هذان ويفعل برنامج الطالب ما يفعله هذا، يُكتب التعقيب.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>المقارنة</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>ما الذي يُقارن</translation>
    </message>
    <message>
        <source>Velocities: they differ at a hit</source>
        <translation>السرعات: تختلف عند تصادم</translation>
    </message>
    <message>
        <source>Positions: they differ in many steps</source>
        <translation>المواضع: تختلف في خطوات كثيرة</translation>
    </message>
    <message>
        <source>Fields: numbers that the program keeps with the circles, as mass</source>
        <translation>الحقول: أعداد يحفظها البرنامج مع الدوائر، مثل mass</translation>
    </message>
</context>
<context>
    <name>cradle::ReportDialog</name>
    <message>
        <source>Looking back at %1</source>
        <translation>نظرة إلى الوراء: ⁨%1⁩</translation>
    </message>
    <message>
        <source>The steps of the lab, and what was hard</source>
        <translation>مراحل المختبر، وما كان صعبًا</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>التقرير (&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>التسليم (&amp;H)…</translation>
    </message>
    <message>
        <source>Every step is judged once more…</source>
        <translation>يُحكم على كل مرحلة مرة أخرى…</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>حفظ التقرير</translation>
    </message>
    <message>
        <source>Documents (*.pdf);;Web pages (*.html)</source>
        <translation>مستندات (*.pdf);;صفحات ويب (*.html)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>حُفظ: ⁨%1⁩</translation>
    </message>
</context>
<context>
    <name>cradle::ResultPane</name>
    <message>
        <source>Checking… %1 of %2</source>
        <translation>جارٍ التحقّق… ⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>جارٍ التحقّق…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>النتيجة</translation>
    </message>
    <message>
        <source>Nothing to check: this scene belongs to no step.</source>
        <translation>لا شيء للتحقّق منه: لا ينتمي هذا المشهد إلى أي مرحلة.</translation>
    </message>
    <message>
        <source>Press Check (Ctrl+Return) when you are done.</source>
        <translation>اضغط «تحقّق» ⁦(Ctrl+Enter)⁩ حين تنتهي.</translation>
    </message>
    <message>
        <source>Changed since this check</source>
        <translation>تغيّر منذ هذا التحقّق</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>ليس بعد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Line %1 ▸</source>
        <translation>السطر ⁨%1⁩ ◂</translation>
    </message>
    <message>
        <source>Show line %1 of the program</source>
        <translation>عرض السطر ⁨%1⁩ من البرنامج</translation>
    </message>
    <message>
        <source>✓ Passed: all %1 checks and answers</source>
        <translation>✓ اجتاز: كل الفحوص والإجابات وعددها ⁨%1⁩</translation>
    </message>
    <message>
        <source>✓ Passed: the check</source>
        <translation>✓ اجتاز: الفحص</translation>
    </message>
    <message>
        <source>✓ Passed: all %1 checks</source>
        <translation>✓ اجتاز: كل الفحوص وعددها ⁨%1⁩</translation>
    </message>
    <message>
        <source>The step counts as passed as soon as the run of this work was shown.</source>
        <translation>تُحسب المرحلة مجتازة حالما يُعرض تشغيل هذا العمل.</translation>
    </message>
    <message>
        <source>✓ You have passed this step</source>
        <translation>✓ لقد اجتزت هذه المرحلة</translation>
    </message>
    <message>
        <source>on %1 at %2</source>
        <translation>في ⁨%1⁩، الساعة ⁨%2⁩</translation>
    </message>
    <message>
        <source>That was the last step.</source>
        <translation>كانت تلك المرحلة الأخيرة.</translation>
    </message>
    <message>
        <source>Still open: %1</source>
        <translation>مراحل لم تُجتز بعد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Next step ▸</source>
        <translation>المرحلة التالية ◂</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>المرحلة التالية</translation>
    </message>
    <message>
        <source>Next step (Ctrl+Page Down)</source>
        <translation>المرحلة التالية ⁦(Ctrl+Page Down)⁩</translation>
    </message>
    <message>
        <source>Compare with the reference ▸</source>
        <translation>المقارنة بالمرجع ◂</translation>
    </message>
    <message>
        <source>Compare with the reference</source>
        <translation>المقارنة بالمرجع</translation>
    </message>
    <message>
        <source>Shows the reference solution beside your program</source>
        <translation>يعرض الحل المرجعي إلى جانب برنامجك</translation>
    </message>
    <message>
        <source>Commit message</source>
        <translation>رسالة الإيداع</translation>
    </message>
    <message>
        <source>Copy the commit message</source>
        <translation>نسخ رسالة الإيداع</translation>
    </message>
    <message>
        <source>Back to the scene that passed ▸</source>
        <translation>العودة إلى المشهد الذي اجتاز ◂</translation>
    </message>
    <message>
        <source>Back to the scene that passed</source>
        <translation>العودة إلى المشهد الذي اجتاز</translation>
    </message>
    <message>
        <source>Sets the values with which you passed this step; Undo takes that back</source>
        <translation>يضبط القيم التي اجتزت بها هذه المرحلة؛ والتراجع يلغي ذلك</translation>
    </message>
</context>
<context>
    <name>cradle::RowsList</name>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Down</translation>
    </message>
</context>
<context>
    <name>cradle::RunDesk</name>
    <message numerus="yes">
        <source>%n runs are pinned; remove one of them first.</source>
        <translation>
            <numerusform>لا تشغيلات مثبّتة.</numerusform>
            <numerusform>تشغيل واحد مثبّت؛ أزله أولًا.</numerusform>
            <numerusform>تشغيلان مثبّتان؛ أزل أحدهما أولًا.</numerusform>
            <numerusform>%n تشغيلات مثبّتة؛ أزل أحدها أولًا.</numerusform>
            <numerusform>%n تشغيلًا مثبّتًا؛ أزل أحدها أولًا.</numerusform>
            <numerusform>%n تشغيل مثبّت؛ أزل أحدها أولًا.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no run yet: press Run, then pin it.</source>
        <translation>لا يوجد تشغيل بعد: اضغط «تشغيل»، ثم ثبّته.</translation>
    </message>
    <message>
        <source>Your program sets values of circles when it is loaded: the new run starts with those.</source>
        <translation>يضبط برنامجك قيم الدوائر عند تحميله: ويبدأ التشغيل الجديد بها.</translation>
    </message>
    <message>
        <source>Save the data of the run</source>
        <translation>حفظ بيانات التشغيل</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>جداول (*.csv)</translation>
    </message>
</context>
<context>
    <name>cradle::SceneActions</name>
    <message>
        <source>Cu&amp;t circles</source>
        <translation>قص الدوائر (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy circles</source>
        <translation>نسخ الدوائر (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste circles</source>
        <translation>لصق الدوائر (&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Duplicate circles</source>
        <translation>تكرار الدوائر (&amp;D)</translation>
    </message>
    <message>
        <source>Re&amp;move circles</source>
        <translation>إزالة الدوائر (&amp;M)</translation>
    </message>
    <message>
        <source>Set velocities to &amp;zero</source>
        <translation>جعل السرعات صفرًا (&amp;Z)</translation>
    </message>
    <message>
        <source>Select a&amp;ll circles</source>
        <translation>تحديد كل الدوائر (&amp;L)</translation>
    </message>
</context>
<context>
    <name>cradle::SceneDesk</name>
    <message>
        <source>Nothing hits anything within the next minute.</source>
        <translation>لا شيء يصدم شيئًا خلال الدقيقة التالية.</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>المرجع</translation>
    </message>
    <message>
        <source>so far in this step</source>
        <translation>حتى الآن في هذه المرحلة</translation>
    </message>
    <message>
        <source>This is a scene of the check, at the moment where it went wrong.</source>
        <translation>هذا مشهد من الفحص، عند لحظة حدوث الخطأ.</translation>
    </message>
    <message>
        <source>This is a scene of the check.</source>
        <translation>هذا مشهد من الفحص.</translation>
    </message>
    <message>
        <source>Back to my scene</source>
        <translation>العودة إلى مشهدي</translation>
    </message>
</context>
<context>
    <name>cradle::SceneEditor</name>
    <message>
        <source>Your program sets this circle in on_load; change it there</source>
        <translation>يضبط برنامجك هذه الدائرة في on_load؛ غيّرها هناك</translation>
    </message>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>لا دوائر</numerusform>
            <numerusform>دائرة واحدة</numerusform>
            <numerusform>دائرتان</numerusform>
            <numerusform>%n دوائر</numerusform>
            <numerusform>%n دائرة</numerusform>
            <numerusform>%n دائرة</numerusform>
        </translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>إضافة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>تكرار ⁨%1⁩</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>إزالة ⁨%1⁩</translation>
    </message>
    <message>
        <source>Set velocity of %1 to zero</source>
        <translation>جعل سرعة ⁨%1⁩ صفرًا</translation>
    </message>
    <message>
        <source>Press Restart (R) to change the start, or start a new run from here (Ctrl+Shift+R)</source>
        <translation>اضغط «إعادة البدء» ⁦(R)⁩ لتغيير البداية، أو ابدأ تشغيلًا جديدًا من هنا ⁦(Ctrl+Shift+R)⁩</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>نقل ⁨%1⁩</translation>
    </message>
    <message>
        <source>Paste a circle</source>
        <translation>لصق دائرة</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n circles</source>
        <translation>
            <numerusform>لصق %n من الدوائر</numerusform>
            <numerusform>لصق دائرة واحدة</numerusform>
            <numerusform>لصق دائرتين</numerusform>
            <numerusform>لصق %n دوائر</numerusform>
            <numerusform>لصق %n دائرة</numerusform>
            <numerusform>لصق %n دائرة</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::SceneForm</name>
    <message>
        <source>Kind</source>
        <translation>النوع</translation>
    </message>
    <message>
        <source>Kind of the scenes</source>
        <translation>نوع المشاهد</translation>
    </message>
</context>
<context>
    <name>cradle::SceneTab</name>
    <message>
        <source>Add the scene that passes</source>
        <translation>إضافة المشهد الذي يجتاز</translation>
    </message>
    <message>
        <source>Remove the scene that passes</source>
        <translation>إزالة المشهد الذي يجتاز</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>قوالب</translation>
    </message>
    <message>
        <source>Scenes to begin with; the one that is here is replaced</source>
        <translation>مشاهد للبدء بها؛ يُستبدل المشهد الموجود هنا</translation>
    </message>
    <message>
        <source>Start from this moment</source>
        <translation>البدء من هذه اللحظة</translation>
    </message>
    <message>
        <source>The circles start where, and as fast as, they are at the moment shown</source>
        <translation>تبدأ الدوائر من مواضعها وبسرعاتها عند اللحظة المعروضة</translation>
    </message>
    <message>
        <source>What the student may not change in this step</source>
        <translation>ما لا يجوز للطالب تغييره في هذه المرحلة</translation>
    </message>
    <message>
        <source>Back to the step&apos;s scene</source>
        <translation>العودة إلى مشهد المرحلة</translation>
    </message>
    <message>
        <source>Remove this scene</source>
        <translation>إزالة هذا المشهد</translation>
    </message>
    <message>
        <source>Students may also pass without a program, by setting the scene and its laws. This step has no scene yet that passes its checks so; with one, the proof looks after it, too.</source>
        <translation>يجوز للطلاب أن يجتازوا دون برنامج أيضًا، بضبط المشهد وقوانينه. ليس لهذه المرحلة بعدُ مشهد يجتاز فحوصها كذلك؛ ومع وجوده يرعاه البرهان أيضًا.</translation>
    </message>
    <message>
        <source>Make it from what the student finds</source>
        <translation>صنعه مما يجده الطالب</translation>
    </message>
    <message>
        <source>What the student finds</source>
        <translation>ما يجده الطالب</translation>
    </message>
    <message>
        <source>What passes without a program</source>
        <translation>ما يجتاز دون برنامج</translation>
    </message>
    <message>
        <source>Which scene of the step</source>
        <translation>أيّ مشهد من المرحلة</translation>
    </message>
    <message>
        <source>Moved by the scene&apos;s laws</source>
        <translation>تحرّكه قوانين المشهد</translation>
    </message>
    <message>
        <source>Moved by solution.lua</source>
        <translation>يحرّكه ⁦solution.lua⁩</translation>
    </message>
    <message>
        <source>What moves the circles here</source>
        <translation>ما الذي يحرّك الدوائر هنا</translation>
    </message>
    <message>
        <source>Take the template %1</source>
        <translation>أخذ القالب ⁨%1⁩</translation>
    </message>
    <message>
        <source>Lock…</source>
        <translation>قفل…</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <translation>مقفل: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Lock a field</source>
        <translation>قفل حقل</translation>
    </message>
    <message>
        <source>Unlock a field</source>
        <translation>فتح قفل حقل</translation>
    </message>
    <message>
        <source>&amp;Rack…</source>
        <translation>مثلث (&amp;R)…</translation>
    </message>
    <message>
        <source>Gr&amp;id…</source>
        <translation>شبكة (&amp;I)…</translation>
    </message>
    <message>
        <source>Ri&amp;ng…</source>
        <translation>حلقة (&amp;N)…</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>كنص</translation>
    </message>
    <message>
        <source>The file of this scene, in which numbers may be expressions</source>
        <translation>ملف هذا المشهد، ويجوز أن تكون الأعداد فيه عبارات</translation>
    </message>
    <message>
        <source>Add a circle: + Add circle</source>
        <translation>لا دائرة بعد: + إضافة دائرة</translation>
    </message>
</context>
<context>
    <name>cradle::SceneText</name>
    <message>
        <source>Write the scene</source>
        <translation>كتابة المشهد</translation>
    </message>
    <message>
        <source>Numbers may be expressions, in quotes: &quot;1 + 0.42*cos(pi/6)&quot;, &quot;20 cm&quot;, or with the lab&apos;s values, &quot;-e*v&quot;. What cannot be read stays here and is not in the lab yet.</source>
        <translation>يجوز أن تكون الأعداد عبارات بين علامتي اقتباس: ⁦&quot;1 + 0.42*cos(pi/6)&quot;⁩ أو ⁦&quot;20 cm&quot;⁩، أو بقيم المختبر ⁦&quot;-e*v&quot;⁩. وما لا يمكن قراءته يبقى هنا ولا يدخل المختبر بعد.</translation>
    </message>
    <message>
        <source>The scene as text</source>
        <translation>المشهد كنص</translation>
    </message>
</context>
<context>
    <name>cradle::SceneView</name>
    <message>
        <source>Scene</source>
        <translation>المشهد</translation>
    </message>
    <message>
        <source>No hit at this moment: N goes on to the next one</source>
        <translation>لا تصادم عند هذه اللحظة: N ينتقل إلى التالي</translation>
    </message>
    <message>
        <source>Add circle here</source>
        <translation>إضافة دائرة هنا</translation>
    </message>
    <message>
        <source>Start a new run from here</source>
        <translation>بدء تشغيل جديد من هنا</translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation>ملاءمة الرؤية</translation>
    </message>
    <message>
        <source>ghost: %1 · %2 m apart</source>
        <translation>الشبح: ⁨%1⁩ · الفرق ⁦%2 m⁩</translation>
    </message>
    <message>
        <source>No exact motion beside more than %1 circles</source>
        <translation>لا حركة دقيقة إلى جانب أكثر من ⁨%1⁩ دائرة</translation>
    </message>
    <message>
        <source>No exact motion: the circles overlap or lie outside at the start</source>
        <translation>لا حركة دقيقة: الدوائر متداخلة أو خارج المربع في البداية</translation>
    </message>
    <message>
        <source>Exact motion; the run is %1 m off</source>
        <translation>الحركة الدقيقة؛ يبعد التشغيل عنها ⁦%1 m⁩</translation>
    </message>
    <message>
        <source>contacts merged from %1 s on</source>
        <translation>دُمجت التلامسات من ⁦%1 s⁩ فصاعدًا</translation>
    </message>
    <message>
        <source>first %1 s dropped</source>
        <translation>أُسقطت أول ⁦%1 s⁩</translation>
    </message>
    <message>
        <source>first %1 min dropped</source>
        <translation>أُسقطت أول ⁦%1 min⁩</translation>
    </message>
    <message>
        <source>Add a circle: Edit → Add circle (Ctrl+Shift+N)</source>
        <translation>إضافة دائرة: تحرير ← إضافة دائرة ⁦(Ctrl+Shift+N)⁩</translation>
    </message>
    <message>
        <source>%1 at %2 m with %3 m/s, radius %4 m</source>
        <translation>⁨%1⁩ في ⁦%2 m⁩ بسرعة ⁦%3 m/s⁩، نصف القطر ⁦%4 m⁩</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>ولا شيء غيرها</numerusform>
            <numerusform>وواحدة غيرها</numerusform>
            <numerusform>واثنتان غيرها</numerusform>
            <numerusform>و%n غيرها</numerusform>
            <numerusform>و%n غيرها</numerusform>
            <numerusform>و%n غيرها</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>لا شيء محدد</numerusform>
            <numerusform>واحدة محددة</numerusform>
            <numerusform>اثنتان محددتان</numerusform>
            <numerusform>%n محددة</numerusform>
            <numerusform>%n محددة</numerusform>
            <numerusform>%n محددة</numerusform>
        </translation>
    </message>
    <message>
        <source>selected: %1</source>
        <translation>المحدد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>No circles</source>
        <translation>لا دوائر</translation>
    </message>
</context>
<context>
    <name>cradle::ShareDialog</name>
    <message>
        <source>Share with git</source>
        <translation>المشاركة بـ git</translation>
    </message>
    <message>
        <source>Your work is a git repository in %1. Its commits and versions can be sent to one of yours elsewhere; who may read that, reads all of them.</source>
        <translation>عملك مستودع git في ⁨%1⁩. يمكن إرسال إيداعاته ونسخه إلى مستودع لك في مكان آخر؛ ومن يجوز له قراءته يقرؤها كلها.</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>العنوان (&amp;A):</translation>
    </message>
    <message>
        <source>Sent so far:</source>
        <translation>أُرسل حتى الآن:</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>إرسال (&amp;S)</translation>
    </message>
    <message>
        <source>All is sent.</source>
        <translation>أُرسل كل شيء.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>جارٍ الإرسال…</translation>
    </message>
    <message>
        <source>up to the commit of %1</source>
        <translation>حتى إيداع ⁨%1⁩</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>لا شيء بعد</translation>
    </message>
</context>
<context>
    <name>cradle::SolutionView</name>
    <message>
        <source>Reference solution</source>
        <translation>الحل المرجعي</translation>
    </message>
    <message>
        <source>Close the reference solution (Esc)</source>
        <translation>إغلاق الحل المرجعي ⁦(Esc)⁩</translation>
    </message>
    <message>
        <source>Close the reference solution</source>
        <translation>إغلاق الحل المرجعي</translation>
    </message>
</context>
<context>
    <name>cradle::Sounds</name>
    <message>
        <source>There is no sound here: no sound server (PulseAudio or PipeWire) could be reached. Everything else goes on.</source>
        <translation>لا صوت هنا: تعذّر الوصول إلى خادم صوت (⁦PulseAudio⁩ أو ⁦PipeWire⁩). وكل ما عداه يستمر.</translation>
    </message>
</context>
<context>
    <name>cradle::SpeedHistogram</name>
    <message>
        <source>Speeds</source>
        <translation>مقادير السرعات</translation>
    </message>
    <message>
        <source>A distribution of speeds takes %1 circles or more: Lab → Example scenes → Gas has 1000</source>
        <translation>يحتاج توزيع مقادير السرعات إلى ⁨%1⁩ دائرة أو أكثر: في «المختبر ← مشاهد أمثلة ← غاز» 1000</translation>
    </message>
    <message>
        <source>Nothing moves yet: press Run</source>
        <translation>لا شيء يتحرك بعد: اضغط «تشغيل»</translation>
    </message>
    <message>
        <source>%1 · v √(m/m̄) · kT = %2 J</source>
        <translation>⁨%1⁩ · ⁦v √(m/m̄)⁩ · ⁦kT = %2 J⁩</translation>
    </message>
    <message>
        <source>%1 · kT = %2 J</source>
        <translation>⁨%1⁩ · ⁦kT = %2 J⁩</translation>
    </message>
    <message>
        <source>share per %1 m/s, mean of 1 s</source>
        <translation>النسبة لكل ⁦%1 m/s⁩، متوسط ⁦1 s⁩</translation>
    </message>
    <message>
        <source>Maxwell–Boltzmann</source>
        <translation>ماكسويل–بولتزمان</translation>
    </message>
    <message>
        <source>In equilibrium: distance from the curve %1, chance allows %2.</source>
        <translation>في اتزان: البعد عن المنحنى ⁨%1⁩، والمصادفة تسمح بـ ⁨%2⁩.</translation>
    </message>
    <message>
        <source>Not in equilibrium: distance from the curve %1, chance allows %2.</source>
        <translation>ليس في اتزان: البعد عن المنحنى ⁨%1⁩، والمصادفة تسمح بـ ⁨%2⁩.</translation>
    </message>
    <message>
        <source>Histogram of the speeds, m/s</source>
        <translation>مدرّج تكراري لمقادير السرعات، ⁦m/s⁩</translation>
    </message>
    <message>
        <source>Distance from equilibrium</source>
        <translation>البعد عن الاتزان</translation>
    </message>
    <message>
        <source>The distance of Kolmogorov and Smirnov, at the moment shown: the greatest difference between the share of circles slower than a speed and what the curve says. Of a hundred gases in equilibrium one is further away by chance.</source>
        <translation>مسافة كولموغوروف وسميرنوف عند اللحظة المعروضة: أكبر فرق بين نسبة الدوائر الأبطأ من سرعة ما وبين ما يقوله المنحنى. من مئة غاز في اتزان يكون واحد أبعد من ذلك بالمصادفة.</translation>
    </message>
</context>
<context>
    <name>cradle::SpeedPlot</name>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>%1 % faster</source>
        <translation>⁦%1 %⁩ أسرع</translation>
    </message>
    <message>
        <source>%1 to %2 m/s: %3 %, the curve %4 %</source>
        <translation>من ⁦%1⁩ إلى ⁦%2 m/s⁩: ⁦%3 %⁩، والمنحنى ⁦%4 %⁩</translation>
    </message>
</context>
<context>
    <name>cradle::StepDesk</name>
    <message>
        <source># %1

This scene belongs to no step: play with it. Choose a step above to go back to the lab.</source>
        <translation># %1

لا ينتمي هذا المشهد إلى أي مرحلة: العب به. اختر مرحلة في الأعلى للعودة إلى المختبر.</translation>
    </message>
    <message>
        <source>A scene of your own</source>
        <translation>مشهد خاص بك</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>استكشاف</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>برمجة</translation>
    </message>
</context>
<context>
    <name>cradle::StepDots</name>
    <message>
        <source>passed</source>
        <translation>اجتيزت</translation>
    </message>
    <message>
        <source>current</source>
        <translation>الحالية</translation>
    </message>
    <message>
        <source>open</source>
        <translation>لم تُجتز بعد</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>المراحل</translation>
    </message>
</context>
<context>
    <name>cradle::StepFields</name>
    <message>
        <source>Rename the step&apos;s folder</source>
        <translation>إعادة تسمية مجلد المرحلة</translation>
    </message>
    <message>
        <source>Edit the step</source>
        <translation>تحرير المرحلة</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>المعرّف</translation>
    </message>
    <message>
        <source>Id of the step, and its folder</source>
        <translation>معرّف المرحلة، ومجلدها</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes; also the name of the folder</source>
        <translation>أحرف لاتينية وأرقام ونقاط وشرطات؛ وهو اسم المجلد أيضًا</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>العنوان</translation>
    </message>
    <message>
        <source>Title of the step</source>
        <translation>عنوان المرحلة</translation>
    </message>
    <message>
        <source>In the language that is open; also in the list of steps (F2)</source>
        <translation>باللغة المفتوحة؛ وفي قائمة المراحل أيضًا ⁦(F2)⁩</translation>
    </message>
    <message>
        <source>Commit message</source>
        <translation>رسالة الإيداع</translation>
    </message>
    <message>
        <source>What a student writes into the history after passing</source>
        <translation>ما يكتبه الطالب في التاريخ بعد الاجتياز</translation>
    </message>
    <message>
        <source>Extra step</source>
        <translation>مرحلة إضافية</translation>
    </message>
    <message>
        <source>Outside the lab&apos;s own count</source>
        <translation>خارج عدّ المختبر نفسه</translation>
    </message>
    <message>
        <source>Moved by program or laws</source>
        <translation>يحركها برنامج أو قوانين</translation>
    </message>
    <message>
        <source>Moved by a program</source>
        <translation>يحركها برنامج</translation>
    </message>
    <message>
        <source>Moved by the laws</source>
        <translation>تحركها القوانين</translation>
    </message>
    <message>
        <source>Who may move the circles</source>
        <translation>من يجوز له تحريك الدوائر</translation>
    </message>
    <message>
        <source>What passes the step: a program of the student, the laws of the scene, or either</source>
        <translation>ما تُجتاز به المرحلة: برنامج الطالب أو قوانين المشهد أو أيّ منهما</translation>
    </message>
</context>
<context>
    <name>cradle::StepsList</name>
    <message>
        <source>extra</source>
        <translation>إضافية</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>اجتيزت</translation>
    </message>
    <message>
        <source>current</source>
        <translation>الحالية</translation>
    </message>
    <message>
        <source>open</source>
        <translation>لم تُجتز بعد</translation>
    </message>
    <message>
        <source>Steps · %1 of %2</source>
        <translation>المراحل · ⁨%1⁩ من ⁨%2⁩</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>المراحل</translation>
    </message>
    <message>
        <source>Steps passed</source>
        <translation>المراحل المجتازة</translation>
    </message>
    <message>
        <source>Close ▴</source>
        <translation>إغلاق ▴</translation>
    </message>
    <message>
        <source>All steps ▾</source>
        <translation>كل المراحل ▾</translation>
    </message>
    <message>
        <source>Close the list of steps</source>
        <translation>إغلاق قائمة المراحل</translation>
    </message>
    <message>
        <source>All steps, %1</source>
        <translation>كل المراحل، ⁨%1⁩</translation>
    </message>
    <message>
        <source>Search the steps</source>
        <translation>بحث في المراحل</translation>
    </message>
    <message>
        <source>1 file of this lab could not be read</source>
        <translation>تعذّرت قراءة ملف واحد من هذا المختبر</translation>
    </message>
    <message>
        <source>%1 files of this lab could not be read</source>
        <translation>تعذّرت قراءة ⁨%1⁩ من ملفات هذا المختبر</translation>
    </message>
</context>
<context>
    <name>cradle::StepsPanel</name>
    <message>
        <source>Steps · %1</source>
        <translation>المراحل · ⁨%1⁩</translation>
    </message>
    <message>
        <source>Steps of the lab</source>
        <translation>مراحل المختبر</translation>
    </message>
    <message>
        <source>Title, version and id of the lab</source>
        <translation>عنوان المختبر ونسخته ومعرّفه</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>إضافة مرحلة</translation>
    </message>
    <message>
        <source>Duplicate the step</source>
        <translation>تكرار المرحلة</translation>
    </message>
    <message>
        <source>Remove the step</source>
        <translation>إزالة المرحلة</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>نقل المرحلة إلى أعلى</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>نقل المرحلة إلى أسفل</translation>
    </message>
    <message>
        <source>New step</source>
        <translation>مرحلة جديدة</translation>
    </message>
    <message>
        <source>Files that the step did not use stay: %1</source>
        <translation>تبقى ملفات لم تستعملها المرحلة: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Rename the step</source>
        <translation>إعادة تسمية المرحلة</translation>
    </message>
    <message>
        <source>Move the step</source>
        <translation>نقل المرحلة</translation>
    </message>
</context>
<context>
    <name>cradle::TextTab</name>
    <message>
        <source>No text in this language yet: students read it in the lab&apos;s own.</source>
        <translation>لا نص بهذه اللغة بعد: يقرؤه الطلاب بلغة المختبر نفسه.</translation>
    </message>
    <message>
        <source>No hint yet: add one with the plus above.</source>
        <translation>لا تلميح بعد: أضف واحدًا بعلامة الزائد في الأعلى.</translation>
    </message>
    <message>
        <source>Line %1: nothing here is called “%2”</source>
        <translation>السطر ⁨%1⁩: لا شيء هنا اسمه «⁨%2⁩»</translation>
    </message>
    <message>
        <source>%1, and %2 more</source>
        <translation>⁨%1⁩، و⁨%2⁩ غيرها</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>التعليمات</translation>
    </message>
    <message>
        <source>Hints without a program</source>
        <translation>تلميحات دون برنامج</translation>
    </message>
    <message>
        <source>Hints for a program</source>
        <translation>تلميحات لبرنامج</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>التوقّع</translation>
    </message>
    <message>
        <source>Questions that count</source>
        <translation>أسئلة تُحسب</translation>
    </message>
    <message>
        <source>As seen in Code mode</source>
        <translation>كما يُرى في وضع البرمجة</translation>
    </message>
    <message>
        <source>As seen in Explore mode</source>
        <translation>كما يُرى في وضع الاستكشاف</translation>
    </message>
    <message>
        <source>Which text</source>
        <translation>أيّ نص</translation>
    </message>
    <message>
        <source>Mode of the preview</source>
        <translation>وضع المعاينة</translation>
    </message>
    <message>
        <source>Insert the scene as a figure</source>
        <translation>إدراج المشهد شكلًا</translation>
    </message>
    <message>
        <source>Draws the moment that the Scene tab shows, with its arrows, as an SVG in the step&apos;s folder</source>
        <translation>يرسم اللحظة التي يعرضها تبويب المشهد، بأسهمها، ملف SVG في مجلد المرحلة</translation>
    </message>
    <message>
        <source>Text in Markdown</source>
        <translation>النص بصيغة Markdown</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>معاينة</translation>
    </message>
    <message>
        <source>Names in backticks that neither the scene nor the programs have</source>
        <translation>أسماء بين علامتي ` ليست في المشهد ولا في البرامج</translation>
    </message>
    <message>
        <source>Edit the text</source>
        <translation>تحرير النص</translation>
    </message>
    <message>
        <source>Edit a hint</source>
        <translation>تحرير تلميح</translation>
    </message>
    <message>
        <source>Change the hints</source>
        <translation>تغيير التلميحات</translation>
    </message>
    <message>
        <source>Edit the prediction</source>
        <translation>تحرير التوقّع</translation>
    </message>
    <message>
        <source>Edit the questions</source>
        <translation>تحرير الأسئلة</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>القيم</translation>
    </message>
</context>
<context>
    <name>cradle::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>خط الزمن</translation>
    </message>
    <message>
        <source>The step shown. Left and Right go a step, Page Up and Page Down to the previous and the next hit.</source>
        <translation>الخطوة المعروضة. السهمان الأيسر والأيمن ينتقلان خطوة، و⁦Page Up⁩ و⁦Page Down⁩ إلى التصادم السابق والتالي.</translation>
    </message>
    <message>
        <source>Drag to any moment</source>
        <translation>اسحب إلى أي لحظة</translation>
    </message>
    <message>
        <source>program stopped in line %1</source>
        <translation>توقف البرنامج في السطر ⁨%1⁩</translation>
    </message>
    <message>
        <source>program stopped</source>
        <translation>توقف البرنامج</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>⁦%1 s⁩</translation>
    </message>
    <message>
        <source>hit %1</source>
        <translation>التصادم %1</translation>
    </message>
    <message>
        <source>hits %1–%2</source>
        <translation>التصادمات ⁦%1–%2⁩</translation>
    </message>
</context>
<context>
    <name>cradle::Tour</name>
    <message>
        <source>End the tour</source>
        <translation>إنهاء الجولة</translation>
    </message>
    <message>
        <source>Tour of the window</source>
        <translation>جولة في النافذة</translation>
    </message>
    <message>
        <source>%1 of %2 · %3</source>
        <translation>⁨%1⁩ من ⁨%2⁩ · ⁨%3⁩</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>بدء</translation>
    </message>
    <message>
        <source>Next ▸</source>
        <translation>التالي ◂</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>التالي</translation>
    </message>
</context>
<context>
    <name>cradle::TransportBar</name>
    <message>
        <source>Pause</source>
        <translation>إيقاف مؤقت</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>تشغيل</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>إيقاف</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>تحقّق</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>إيقاف التحقّق</translation>
    </message>
    <message>
        <source>Check this step</source>
        <translation>التحقّق من هذه المرحلة</translation>
    </message>
    <message>
        <source>Stop</source>
        <comment>search</comment>
        <translation>إيقاف</translation>
    </message>
    <message>
        <source>Next hit</source>
        <translation>التصادم التالي</translation>
    </message>
    <message>
        <source>End the search and go back to where it began</source>
        <translation>إنهاء البحث والعودة إلى حيث بدأ</translation>
    </message>
    <message>
        <source>Run on to the next collision</source>
        <translation>المضي حتى التصادم التالي</translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation>⁦t = %1 s⁩</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>الخطوة %1</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>إعادة البدء</translation>
    </message>
    <message>
        <source>Back to the start of the run</source>
        <translation>العودة إلى بداية التشغيل</translation>
    </message>
    <message>
        <source>Step back</source>
        <translation>خطوة إلى الوراء</translation>
    </message>
    <message>
        <source>Step</source>
        <comment>back</comment>
        <translation>خطوة</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>خطوة واحدة إلى الوراء</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>خطوة</translation>
    </message>
    <message>
        <source>One step on</source>
        <translation>خطوة واحدة إلى الأمام</translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation>تشغيل أو إيقاف مؤقت</translation>
    </message>
    <message>
        <source>Previous hit</source>
        <translation>التصادم السابق</translation>
    </message>
    <message>
        <source>Back to the collision before, or to the start</source>
        <translation>العودة إلى التصادم السابق، أو إلى البداية</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>أبطأ</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>أسرع</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>السرعة</translation>
    </message>
    <message>
        <source>Speed now</source>
        <translation>السرعة الآن</translation>
    </message>
    <message>
        <source>How fast it goes now: slower around a hit, if that is chosen</source>
        <translation>ما سرعة السير الآن: أبطأ حول التصادم إن اختير ذلك</translation>
    </message>
    <message>
        <source>Simulated time per real time ([ slower, ] faster)</source>
        <translation>الزمن المحاكى لكل زمن حقيقي (⁦[⁩ أبطأ، ⁦]⁩ أسرع)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>الزمن</translation>
    </message>
    <message>
        <source>Steps since the start</source>
        <translation>الخطوات منذ البداية</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>تقدّم التحقّق</translation>
    </message>
    <message>
        <source>Progress of the search for a hit</source>
        <translation>تقدّم البحث عن تصادم</translation>
    </message>
</context>
<context>
    <name>cradle::UndoActions</name>
    <message>
        <source>typing</source>
        <translation>كتابة</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>تراجع (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>إعادة (&amp;R)</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesEditor</name>
    <message>
        <source>Values · %1</source>
        <translation>القيم · ⁨%1⁩</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, drawn</source>
        <translation>⁨%1⁩: من ⁨%2⁩ إلى ⁨%3⁩، بالقرعة</translation>
    </message>
    <message>
        <source>%1 (whole lab)</source>
        <translation>⁨%1⁩ (المختبر كله)</translation>
    </message>
    <message>
        <source>Write {{%1}} in texts, programs and checks; in scenes and other values %1 alone.</source>
        <translation>اكتب ⁦{{%1}}⁩ في النصوص والبرامج والفحوص؛ وفي المشاهد والقيم الأخرى ⁦%1⁩ وحده.</translation>
    </message>
    <message numerus="yes">
        <source>Each student gets one of %n number(s): %1. You, and who gives no number, have the first.</source>
        <translation>
            <numerusform>لا يحصل أي طالب على عدد من %n: ⁨%1⁩. أنت ومن لا يعطي رقمًا لكم الأول.</numerusform>
            <numerusform>يحصل كل طالب على عدد واحد: ⁨%1⁩. أنت ومن لا يعطي رقمًا لكم الأول.</numerusform>
            <numerusform>يحصل كل طالب على أحد عددين: ⁨%1⁩. أنت ومن لا يعطي رقمًا لكم الأول.</numerusform>
            <numerusform>يحصل كل طالب على واحد من %n أعداد: ⁨%1⁩. أنت ومن لا يعطي رقمًا لكم الأول.</numerusform>
            <numerusform>يحصل كل طالب على واحد من %n عددًا: ⁨%1⁩. أنت ومن لا يعطي رقمًا لكم الأول.</numerusform>
            <numerusform>يحصل كل طالب على واحد من %n عدد: ⁨%1⁩. أنت ومن لا يعطي رقمًا لكم الأول.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing uses it yet.</source>
        <translation>لا شيء يستعملها بعد.</translation>
    </message>
    <message>
        <source>Used in %1.</source>
        <translation>مستعملة في ⁨%1⁩.</translation>
    </message>
    <message>
        <source>Student %1 has %2 = %3</source>
        <translation>للطالب ⁨%1⁩: ⁦%2 = %3⁩</translation>
    </message>
    <message>
        <source>Edit a value</source>
        <translation>تحرير قيمة</translation>
    </message>
    <message>
        <source>A name of letters, digits and underscores that means nothing else, as sin does, is right</source>
        <translation>الصواب اسم من أحرف لاتينية وأرقام وشرطات سفلية لا يعني شيئًا آخر كما يعني sin</translation>
    </message>
    <message>
        <source>Another value has this name already</source>
        <translation>لقيمة أخرى هذا الاسم بالفعل</translation>
    </message>
    <message>
        <source>There is a value %1 already</source>
        <translation>توجد قيمة ⁨%1⁩ بالفعل</translation>
    </message>
    <message>
        <source>Edit the draw</source>
        <translation>تحرير القرعة</translation>
    </message>
    <message>
        <source>Add a value</source>
        <translation>إضافة قيمة</translation>
    </message>
    <message>
        <source>Remove a value</source>
        <translation>إزالة قيمة</translation>
    </message>
    <message>
        <source>Values of the lab and of the step</source>
        <translation>قيم المختبر والمرحلة</translation>
    </message>
    <message>
        <source>Remove the value</source>
        <translation>إزالة القيمة</translation>
    </message>
    <message>
        <source>No number has a name yet. Add one with the plus, and write it in braces, as {{e}}, where texts, programs and checks need it: then it stands in one place, and may be another for each student.</source>
        <translation>لا عدد له اسم بعد. أضف واحدًا بعلامة الزائد واكتبه بين أقواس معقوفة، مثل ⁦{{e}}⁩، حيث تحتاج إليه النصوص والبرامج والفحوص: فيقع في موضع واحد، وقد يختلف لكل طالب.</translation>
    </message>
    <message>
        <source>The same for all</source>
        <translation>واحدة للجميع</translation>
    </message>
    <message>
        <source>Drawn for each student</source>
        <translation>بالقرعة لكل طالب</translation>
    </message>
    <message>
        <source>In the whole lab</source>
        <translation>في المختبر كله</translation>
    </message>
    <message>
        <source>In this step</source>
        <translation>في هذه المرحلة</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>النوع</translation>
    </message>
    <message>
        <source>Whether the value is drawn</source>
        <translation>هل تُختار القيمة بالقرعة</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>معروفة</translation>
    </message>
    <message>
        <source>Where the value is known</source>
        <translation>أين تُعرف القيمة</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>الاسم</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>القيمة</translation>
    </message>
    <message>
        <source>From</source>
        <translation>من</translation>
    </message>
    <message>
        <source>To</source>
        <translation>إلى</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>الخطوة</translation>
    </message>
    <message>
        <source>Letters, digits and underscores</source>
        <translation>أحرف لاتينية وأرقام وشرطات سفلية</translation>
    </message>
    <message>
        <source>A number, or an expression like 2*k or sqrt(2*9.81*5), in the unit that its uses want</source>
        <translation>عدد، أو عبارة مثل ⁦2*k⁩ أو ⁦sqrt(2*9.81*5)⁩، بالوحدة التي تطلبها مواضع استعماله</translation>
    </message>
    <message>
        <source>From one number to the next</source>
        <translation>من عدد إلى الذي يليه</translation>
    </message>
    <message>
        <source>Student number</source>
        <translation>رقم الطالب</translation>
    </message>
    <message>
        <source>Student number to try the draw with</source>
        <translation>رقم طالب لتجربة القرعة</translation>
    </message>
    <message>
        <source>To see what that student gets; it is kept nowhere</source>
        <translation>لرؤية ما يحصل عليه ذلك الطالب؛ ولا يُحفظ في أي مكان</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>القرعة</translation>
    </message>
    <message>
        <source>Draw of the lab</source>
        <translation>قرعة المختبر</translation>
    </message>
    <message>
        <source>Another text draws other values: change it every year</source>
        <translation>نص آخر يعطي قيمًا أخرى: غيّره كل عام</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesModel</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Position to the right of the middle</source>
        <translation>الموضع يمين الوسط</translation>
    </message>
    <message>
        <source>Position above the middle</source>
        <translation>الموضع فوق الوسط</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>السرعة نحو اليمين</translation>
    </message>
    <message>
        <source>Velocity upwards</source>
        <translation>السرعة نحو الأعلى</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>مقدار السرعة</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>كمية الحركة نحو اليمين</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>كمية الحركة نحو الأعلى</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>الحركية</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>الطاقة الحركية</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>الكتلة</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>البعد عن الحركة الدقيقة</translation>
    </message>
    <message>
        <source>Total energy more than in the exact motion</source>
        <translation>الطاقة الكلية زيادةً على الحركة الدقيقة</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>number unit</comment>
        <translation>⁦%1 %2⁩</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>quantity, unit</comment>
        <translation>⁨%1⁩، ⁨%2⁩</translation>
    </message>
    <message>
        <source>All circles together</source>
        <translation>كل الدوائر معًا</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesPane</name>
    <message>
        <source>%1 •</source>
        <comment>a tab with news</comment>
        <translation>%1 •</translation>
    </message>
    <message>
        <source>Hits %1</source>
        <translation>التصادمات %1</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>التصادمات</translation>
    </message>
    <message>
        <source>number</source>
        <translation>رقم</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>القيم</translation>
    </message>
    <message>
        <source>Values and hits</source>
        <translation>القيم والتصادمات</translation>
    </message>
    <message>
        <source>Hits; Enter shows the moment</source>
        <translation>التصادمات؛ Enter يعرض اللحظة</translation>
    </message>
    <message>
        <source>No hits yet: press Run or Next hit</source>
        <translation>لا تصادمات بعد: اضغط «تشغيل» أو «التصادم التالي»</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>نسخ</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>نسخ الكل</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesTab</name>
    <message>
        <source>No hit so far.</source>
        <translation>لا تصادم حتى الآن.</translation>
    </message>
    <message>
        <source>Values of the circles at the moment shown</source>
        <translation>قيم الدوائر عند اللحظة المعروضة</translation>
    </message>
    <message>
        <source>Last hit</source>
        <translation>آخر تصادم</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>البعد عن الحركة الدقيقة</translation>
    </message>
</context>
<context>
    <name>cradle::VerdictDesk</name>
    <message>
        <source>Not yet: %1</source>
        <translation>ليس بعد: ⁨%1⁩</translation>
    </message>
    <message>
        <source>Check passed.</source>
        <translation>اجتزت التحقّق.</translation>
    </message>
</context>
<context>
    <name>cradle::VersionsList</name>
    <message>
        <source>Written</source>
        <translation>كُتب</translation>
    </message>
    <message>
        <source>Before it was replaced</source>
        <translation>قبل استبداله</translation>
    </message>
    <message>
        <source>By another program</source>
        <translation>بواسطة برنامج آخر</translation>
    </message>
    <message>
        <source>From another window</source>
        <translation>من نافذة أخرى</translation>
    </message>
    <message>
        <source>✓ passed</source>
        <translation>✓ اجتاز</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>لم يجتز</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>السطر ⁨%1⁩: ⁨%2⁩</translation>
    </message>
    <message>
        <source>without: %1</source>
        <translation>من دون: ⁨%1⁩</translation>
    </message>
    <message>
        <source>the same program</source>
        <translation>البرنامج نفسه</translation>
    </message>
    <message>
        <source>When</source>
        <translation>متى</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>النسخة</translation>
    </message>
    <message>
        <source>First difference</source>
        <translation>أول فرق</translation>
    </message>
    <message>
        <source>Versions of this step&apos;s program</source>
        <translation>نسخ برنامج هذه المرحلة</translation>
    </message>
</context>
<context>
    <name>cradle::VersionsPane</name>
    <message>
        <source>Versions</source>
        <translation>النسخ</translation>
    </message>
    <message>
        <source>Every Check keeps a version of your program here, and so do ten minutes of writing.</source>
        <translation>كل تحقّق يحفظ هنا نسخة من برنامجك، وكذلك كل عشر دقائق من الكتابة.</translation>
    </message>
    <message>
        <source>The version</source>
        <translation>النسخة</translation>
    </message>
    <message>
        <source>Your program now</source>
        <translation>برنامجك الآن</translation>
    </message>
    <message>
        <source>&amp;Go back to this</source>
        <translation>العودة إلى هذه (&amp;G)</translation>
    </message>
    <message>
        <source>Your program now becomes a version, so nothing is lost</source>
        <translation>يصير برنامجك الحالي نسخة، فلا يضيع شيء</translation>
    </message>
    <message>
        <source>Back to what &amp;passed</source>
        <translation>العودة إلى ما اجتاز (&amp;P)</translation>
    </message>
    <message>
        <source>To the newest version that passed this step</source>
        <translation>إلى أحدث نسخة اجتازت هذه المرحلة</translation>
    </message>
</context>
<context>
    <name>cradle::WaysBack</name>
    <message>
        <source>Back to the scene that passed</source>
        <translation>العودة إلى المشهد الذي اجتاز</translation>
    </message>
</context>
<context>
    <name>cradle::WorkDialogs</name>
    <message>
        <source>Nothing of this work is kept on a disk.</source>
        <translation>لا يُحفظ شيء من هذا العمل على قرص.</translation>
    </message>
    <message>
        <source>Open a step of a lab first.</source>
        <translation>افتح مرحلة من مختبر أولًا.</translation>
    </message>
</context>
<context>
    <name>cradle::WorkJob</name>
    <message>
        <source>What you typed last could not be saved; on the disk your work is older. Save it first: the window says what is in the way.</source>
        <translation>تعذّر حفظ ما كتبته أخيرًا؛ وعملك على القرص أقدم. احفظه أولًا: تقول النافذة ما الذي يعيق.</translation>
    </message>
</context>
<context>
    <name>cradle::WorkNotices</name>
    <message>
        <source>Another program has changed your program. Its text is shown now; yours is among the versions of this step.</source>
        <translation>غيّر برنامج آخر برنامجك. يُعرض نصه الآن؛ ونصك بين نسخ هذه المرحلة.</translation>
    </message>
    <message>
        <source>Another program has changed your program while you typed. Yours stays; the other is among the versions of this step.</source>
        <translation>غيّر برنامج آخر برنامجك وأنت تكتب. يبقى نصك؛ والآخر بين نسخ هذه المرحلة.</translation>
    </message>
    <message>
        <source>Another program has made %1 a file that is no program. It is kept as %2; what can be read of it is among the versions of this step.</source>
        <translation>جعل برنامج آخر ⁨%1⁩ ملفًا ليس برنامجًا. يُحفظ باسم ⁨%2⁩؛ وما يُقرأ منه بين نسخ هذه المرحلة.</translation>
    </message>
    <message>
        <source>Your number</source>
        <translation>رقمك</translation>
    </message>
    <message>
        <source>This lab draws its values for each student by the number that you hand in with.
Your number:</source>
        <translation>يختار هذا المختبر قيمه لكل طالب بحسب الرقم الذي تسلّم به.
رقمك:</translation>
    </message>
    <message>
        <source>The values of this lab are those of nobody until you give your number: open the lab again for that.</source>
        <translation>قيم هذا المختبر ليست قيم أحد حتى تعطي رقمك: افتح المختبر مرة أخرى لذلك.</translation>
    </message>
    <message>
        <source>Work that %1 handed in. Run it, check it, read its versions and notes: nothing of it is changed, and nothing of what it says about itself is believed.</source>
        <translation>عمل سلّمه ⁨%1⁩. شغّله وافحصه واقرأ نسخه وملاحظاته: لا يُغيَّر فيه شيء، ولا يُصدَّق شيء مما يقوله عن نفسه.</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>شخص ما</translation>
    </message>
    <message>
        <source>They write: “%1”</source>
        <translation>ويكتب: «⁨%1⁩»</translation>
    </message>
    <message>
        <source>Make a program of it</source>
        <translation>جعله برنامجًا</translation>
    </message>
    <message>
        <source>Back to the newest version</source>
        <translation>العودة إلى أحدث نسخة</translation>
    </message>
    <message>
        <source>Begin this step anew</source>
        <translation>بدء هذه المرحلة من جديد</translation>
    </message>
    <message>
        <source>The file of your program is no program, and is left as it is. %1 Whatever you choose, the file is kept beside it.</source>
        <translation>ملف برنامجك ليس برنامجًا، ويُترك كما هو. ⁨%1⁩ أيًّا كان اختيارك، يُحفظ الملف بجواره.</translation>
    </message>
    <message>
        <source>This step goes on from the one before, which you have not done. You begin with your own program.</source>
        <translation>تواصل هذه المرحلة من التي قبلها، ولم تنجزها. تبدأ ببرنامجك أنت.</translation>
    </message>
    <message>
        <source>Begin with the solution of “%1”</source>
        <translation>البدء بحل «⁨%1⁩»</translation>
    </message>
    <message>
        <source>Read the step on the left, write your program in the middle, press Run to watch, and Check when you are done.</source>
        <translation>اقرأ المرحلة على اليمين، واكتب برنامجك في الوسط، واضغط «تشغيل» للمشاهدة، و«تحقّق» حين تنتهي.</translation>
    </message>
    <message>
        <source>Read the step on the left, set the values beside the scene, press Run to watch, and Check when you are done.</source>
        <translation>اقرأ المرحلة على اليمين، واضبط القيم بجانب المشهد، واضغط «تشغيل» للمشاهدة، و«تحقّق» حين تنتهي.</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>خذني في جولة</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>فهمت</translation>
    </message>
    <message>
        <source>Another window works on this lab (process %1 on %2, since %3). In this one you can look, but nothing is saved.</source>
        <translation>تعمل نافذة أخرى على هذا المختبر (العملية ⁨%1⁩ على ⁨%2⁩، منذ ⁨%3⁩). يمكنك هنا أن تنظر، لكن لا يُحفظ شيء.</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>تولّي العمل هنا</translation>
    </message>
    <message>
        <source>What you pass is kept in your history, signed “Student”. It can be signed with your name.</source>
        <translation>ما تجتازه يُحفظ في تاريخك بتوقيع «Student». ويمكن توقيعه باسمك.</translation>
    </message>
    <message>
        <source>Give your name…</source>
        <translation>إعطاء اسمك…</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>اسمك</translation>
    </message>
    <message>
        <source>Your name:</source>
        <translation>اسمك:</translation>
    </message>
    <message>
        <source>Your program is not saved</source>
        <translation>برنامجك لم يُحفظ</translation>
    </message>
    <message>
        <source>What you typed since it was last saved is lost if you close the window.</source>
        <translation>ما كتبته منذ آخر حفظ يضيع إن أغلقت النافذة.</translation>
    </message>
</context>
<context>
    <name>cradle::Workbench</name>
    <message>
        <source>this is work in the lab %1, which is not here; open that lab once, and then the work</source>
        <translation>هذا عمل في المختبر ⁨%1⁩، وهو ليس هنا؛ افتح ذلك المختبر مرة، ثم العمل</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>فتح مشهد</translation>
    </message>
</context>
<context>
    <name>cradle::WorldGroup</name>
    <message>
        <source>World</source>
        <translation>العالم</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>الجاذبية</translation>
    </message>
    <message>
        <source>Restitution e</source>
        <translation>معامل الارتداد e</translation>
    </message>
    <message>
        <source>Timestep</source>
        <translation>الخطوة الزمنية</translation>
    </message>
    <message>
        <source>Half width</source>
        <translation>نصف العرض</translation>
    </message>
    <message>
        <source>Acceleration of every circle, to the right and upward</source>
        <translation>تسارع كل دائرة، نحو اليمين ونحو الأعلى</translation>
    </message>
    <message>
        <source>From 0, no rebound, to 1, elastic</source>
        <translation>من 0، بلا ارتداد، إلى 1، مرن</translation>
    </message>
    <message>
        <source>Up doubles it, Down halves it; 1/240 can be typed</source>
        <translation>السهم الأعلى يضاعفها، والأسفل ينصّفها؛ ويمكن كتابة ⁦1/240⁩</translation>
    </message>
    <message>
        <source>From the middle of the square to a wall</source>
        <translation>من وسط المربع إلى جدار</translation>
    </message>
    <message>
        <source>Gravity to the right, m/s²</source>
        <translation>الجاذبية نحو اليمين، ⁦m/s²⁩</translation>
    </message>
    <message>
        <source>Gravity upward, m/s²</source>
        <translation>الجاذبية نحو الأعلى، ⁦m/s²⁩</translation>
    </message>
    <message>
        <source>Timestep, s</source>
        <translation>الخطوة الزمنية، s</translation>
    </message>
    <message>
        <source>Half width of the square, m</source>
        <translation>نصف عرض المربع، m</translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation>⁦= %1 s⁩</translation>
    </message>
    <message>
        <source>Change gravity</source>
        <translation>تغيير الجاذبية</translation>
    </message>
    <message>
        <source>Change restitution</source>
        <translation>تغيير معامل الارتداد</translation>
    </message>
    <message>
        <source>Change timestep</source>
        <translation>تغيير الخطوة الزمنية</translation>
    </message>
    <message>
        <source>Change half width</source>
        <translation>تغيير نصف العرض</translation>
    </message>
</context>
</TS>
