//! Turkish translations of the titles, sources and notes in the built-in scenes, and of the titles of
//! the built-in tasks. A changed text has no translation and is shown as it is.

/// Returns the translation of a text in a built-in scene, or any other text unchanged.
pub(super) fn said(text: &str) -> &str {
    let known = TEXTS.iter().find(|(english, _)| *english == text);
    known.map_or(text, |(_, turkish)| turkish)
}

#[rustfmt::skip]
const TEXTS: [(&str, &str); 109] = [
    (
        "Four-bar crank-rocker",
        "Dört çubuk, krank-sarkaç",
    ),
    (
        "lecture on machine dynamics, weeks 3 and 7: position and acceleration analysis",
        "makine dinamiği dersi, 3. ve 7. hafta: konum ve ivme analizi",
    ),
    (
        "the crank r2 turns fully, the rocker r4 swings; at 60 deg every figure of the lecture can be read",
        "krank r2 tam döner, sarkaç r4 salınır; 60 deg konumunda dersin bütün değerleri okunur",
    ),
    (
        "Slider-crank in line",
        "Krank-biyel, eksende",
    ),
    (
        "lecture on machine dynamics, week 4: velocity and acceleration analysis of a slider-crank",
        "makine dinamiği dersi, 4. hafta: krank-biyel mekanizmasının hız ve ivme analizi",
    ),
    (
        "the slider C moves fastest shortly before the crank stands square to the rod, not at 90 deg",
        "kızak C en hızlı 90 deg konumunda değil, krank biyele dik durmadan biraz öncedir",
    ),
    (
        "Press of two four-bars",
        "İki dört çubuklu pres",
    ),
    (
        "a press of two loops as in a lecture's homework on position analysis; own dimensions",
        "konum analizi ödevindeki gibi iki döngülü bir pres; boyutlar kendimizden",
    ),
    (
        "One crank moves two loops in series: the bell-crank r4 is the rocker of the first four-bar (it swings 48 degrees) and the crank of the second.",
        "Tek krank art arda iki döngüyü hareket ettirir: dirsekli kol r4 birinci dört çubuğun sarkacı (48 derece salınır), ikincinin krankıdır.",
    ),
    (
        "Press with a ram",
        "Koçlu pres",
    ),
    (
        "the drive of the press of two four-bars, ended by a vertical ram; own dimensions",
        "iki dört çubuklu presin tahriki, ucunda düşey bir koçla; boyutlar kendimizden",
    ),
    (
        "The ram goes down and up as the bell-crank r4 rocks. It is a link that slides without turning, so the tool below its pin keeps its attitude.",
        "Dirsekli kol r4 salındıkça koç inip çıkar. Koç dönmeden kayan bir uzuvdur, piminin altındaki takım yönünü korur.",
    ),
    (
        "Four-bar that lifts a load",
        "Yük kaldıran dört çubuk",
    ),
    (
        "lecture on machine dynamics, week 3: 500 N against the motor's torque; the masses are own",
        "makine dinamiği dersi, 3. hafta: 500 N, motorun torkuna karşı; kütleler kendimizden",
    ),
    (
        "The lecture's four-bar with 500 N hung from its rocker: the motor lifts them and is driven back by them, and at 15 rad/s the links' inertia counts too. The crank is balanced: its centre of mass is its pivot.",
        "Dersin dört çubuğunun sarkacına 500 N asılı: motor yükü kaldırır, yük de motoru geri sürer; 15 rad/s hızda uzuvların ataleti de sayılır. Krank dengelidir: ağırlık merkezi mesnetindedir.",
    ),
    (
        "Engine",
        "İçten yanmalı motor",
    ),
    (
        "a four-stroke of 86 x 86 mm with one cylinder, 0.5 l; gas forces from polytropes between 0.85 and 55 bar",
        "tek silindirli dört zamanlı motor, 86 x 86 mm, 0.5 l; gaz kuvvetleri 0.85 ile 55 bar arasında politroplardan",
    ),
    (
        "The gas pushes for one stroke in four, from 0 deg on; the fourth begins at 540. So the torque repeats after 720 deg, though the linkage does after 360. On the firing stroke the gas is stronger than all inertia by far, on the other three it is the other way round.",
        "Gaz dört stroktan birinde, 0 deg konumundan başlayarak iter; dördüncü strok 540 deg konumunda başlar. Tork bu yüzden 720 deg sonra yinelenir, mekanizma ise 360 deg sonra. İş strokunda gaz bütün ataletten çok daha güçlüdür, öteki üçünde tersi olur.",
    ),
    (
        "Offset slider-crank",
        "Kaçık krank-biyel",
    ),
    (
        "a textbook quick-return slider-crank; own dimensions, rod > crank + offset",
        "ders kitaplarındaki çabuk dönüşlü krank-biyel; boyutlar kendimizden, biyel > krank + kaçıklık",
    ),
    (
        "The guide lies 50 mm below the crank's pivot, so the two strokes take unequal times: 200.5 to 159.5 degrees of the crank, a time ratio of 1.26.",
        "Kılavuz, krankın mesnetinden 50 mm aşağıdadır; iki strok bu yüzden farklı sürer: krankın 200.5 ve 159.5 derecesi, zaman oranı 1.26.",
    ),
    (
        "Slotted lever",
        "Yarıklı kol",
    ),
    (
        "the crank and slotted lever quick return of the textbooks (an inverted slider-crank); own dimensions",
        "ders kitaplarındaki yarıklı kollu çabuk dönüş (evrik krank-biyel); boyutlar kendimizden",
    ),
    (
        "The crank's pin drives the lever through a slot. The lever swings 24.6 degrees to each side, quickly while the pin is below the crank's pivot.",
        "Krankın pimi kolu bir yarıktan sürer. Kol iki yana 24.6 derece salınır, pim krankın mesnetinden aşağıdayken çabuk.",
    ),
    (
        "Whitworth quick return",
        "Whitworth çabuk dönüşü",
    ),
    (
        "J. Whitworth's quick return for shapers as in the textbooks; own dimensions",
        "J. Whitworth'un vargel tezgâhları için çabuk dönüşü, ders kitaplarındaki gibi; boyutlar kendimizden",
    ),
    (
        "The lever's pivot lies inside the crank's circle, so the lever turns fully but unevenly: the tool cuts slowly to one side and hurries back (time ratio 2).",
        "Kolun mesneti krankın çemberinin içindedir; kol tam döner, ama düzgün değil: takım bir yana yavaş keser, öteki yana çabuk döner (zaman oranı 2).",
    ),
    (
        "Scotch yoke",
        "İskoç boyunduruğu",
    ),
    (
        "a double slider of the textbooks; own dimensions",
        "ders kitaplarındaki çift kızaklı mekanizma; boyutlar kendimizden",
    ),
    (
        "The yoke follows the cosine of the crank's angle exactly: its position, velocity and acceleration are harmonic.",
        "Boyunduruk krank açısının kosinüsünü tam izler: konumu, hızı ve ivmesi harmoniktir.",
    ),
    (
        "Chebyshev's double rocker",
        "Chebyshev'in çift sarkacı",
    ),
    (
        "P. L. Chebyshev's straight-line linkage: frame, rockers and coupler as 4 : 5 : 2",
        "P. L. Chebyshev'in doğru çizen mekanizması: şase, sarkaçlar ve biyel 4 : 5 : 2",
    ),
    (
        "Neither rocker can turn fully: the driven one swings from 36.87 degrees (cos 4/5) to 101.54 (cos -1/5). Midway, P on the coupler runs along an almost straight line.",
        "İki sarkaç da tam dönemez: tahrik edilen 36.87 dereceden (cos 4/5) 101.54 dereceye (cos -1/5) salınır. Ortada biyelin P noktası neredeyse bir doğru boyunca gider.",
    ),
    (
        "Drag link",
        "Çift krank (sürükleyici)",
    ),
    (
        "a Grashof double crank as in the textbooks; own dimensions, frame : crank : coupler : crank as 1 : 2 : 2.5 : 2.2",
        "ders kitaplarındaki Grashof çift krankı; boyutlar kendimizden, şase : krank : biyel : krank 1 : 2 : 2.5 : 2.2",
    ),
    (
        "The shortest link is the frame, so both cranks turn fully. The driven one turns evenly, the other hurries and lingers.",
        "En kısa uzuv şasedir, bu yüzden iki krank da tam döner. Tahrik edilen düzgün döner, öteki kimi yerde hızlanır, kimi yerde oyalanır.",
    ),
    (
        "Watt's six-bar",
        "Watt'ın altı çubuğu",
    ),
    (
        "Watt's second six-bar chain (two four-bars that share a ternary rocker), in the textbooks' notation; own dimensions",
        "Watt'ın ikinci altı çubuk zinciri (üç mafsallı sarkacı ortak iki dört çubuk), ders kitaplarının gösterimiyle; boyutlar kendimizden",
    ),
    (
        "Two ternary links, the frame and r4: its arm E hands the swing of the first four-bar, 45 degrees, to the rocker r6 of the second.",
        "Üç mafsallı iki uzuv, şase ve r4: onun E kolu birinci dört çubuğun 45 derecelik salınımını ikincinin sarkacı r6 uzvuna iletir.",
    ),
    (
        "Stephenson's six-bar, driven across its loops",
        "Stephenson'ın altı çubuğu, döngülerin karşısından tahrikli",
    ),
    (
        "Stephenson's third six-bar chain, driven at the dyad's side; own dimensions",
        "Stephenson'ın üçüncü altı çubuk zinciri, ikili grubun yanından tahrikli; boyutlar kendimizden",
    ),
    (
        "No dyad can be solved by itself: three legs carry the ternary coupler r4 at once (an Assur group of class III), so all of them are solved together, by Newton.",
        "Hiçbir ikili grup tek başına çözülemez: üç bacak, üç mafsallı biyel r4 uzvunu birlikte taşır (III. sınıf Assur grubu); bu yüzden hepsi birlikte, Newton yöntemiyle çözülür.",
    ),
    (
        "Jansen's walking leg",
        "Jansen'in yürüyen bacağı",
    ),
    (
        "Theo Jansen's strandbeest: his 'holy numbers' a to m (The Great Pretender, 2007), here in cm",
        "Theo Jansen'in strandbeest'i: a'dan m'ye 'kutsal sayıları' (The Great Pretender, 2007), burada cm",
    ),
    (
        "Eight links turn one crank into a step: the foot T keeps to the ground for more than half a turn and is lifted over the rest.",
        "Sekiz uzuv bir krankın dönüşünü adıma çevirir: ayak T yarım turdan uzun süre yerde kalır, geri kalanda kalkar.",
    ),
    (
        "Klann's walking leg",
        "Klann'ın yürüyen bacağı",
    ),
    (
        "the example leg of US patent 6,260,862 (J. C. Klann, 2001): its coordinates times 100, the crankshaft at the origin",
        "ABD patenti 6,260,862'nin örnek bacağı (J. C. Klann, 2001): koordinatları 100 katı, krank mili başlangıçta",
    ),
    (
        "The foot walks along a nearly level line for almost half a turn of the crank and is lifted for the rest; the body would travel to the right.",
        "Ayak, krankın neredeyse yarım turu boyunca hemen hemen düz bir çizgide yürür, geri kalanda kalkar; gövde sağa giderdi.",
    ),
    (
        "Peaucellier's cell",
        "Peaucellier hücresi",
    ),
    (
        "C.-N. Peaucellier's inversor (1864): long arms 100, rhombus 40, so that OB times OD is 100^2 - 40^2; own dimensions",
        "C.-N. Peaucellier'in evirteci (1864): uzun kollar 100, eşkenar dörtgen 40, böylece OB çarpı OD 100^2 - 40^2; boyutlar kendimizden",
    ),
    (
        "Seven links draw a true straight line: P stays at x = 105 exactly, for B lies on a circle through O. The driver stops where the rhombus folds, at 82.82 degrees to each side.",
        "Yedi uzuv tam bir doğru çizer: P tam x = 105 üzerinde kalır, çünkü B, O noktasından geçen bir çember üzerindedir. Tahrik, eşkenar dörtgenin kapandığı yerde, iki yana 82.82 derecede durur.",
    ),
    (
        "Hoecken's straight-line linkage",
        "Hoecken'in doğru çizen mekanizması",
    ),
    (
        "after K. Hoecken: frame : crank : coupler : rocker as 2 : 1 : 2.5 : 2.5, the coupler prolonged to twice its length",
        "K. Hoecken'e göre: şase : krank : biyel : sarkaç 2 : 1 : 2.5 : 2.5, biyel iki katı boya uzatılmış",
    ),
    (
        "P follows an almost straight line at almost constant speed for half a turn of the crank, from 90 to 270 degrees, then hurries back in an arc.",
        "P, krankın yarım turu boyunca, 90 dereceden 270 dereceye, neredeyse sabit hızla neredeyse bir doğru çizer, sonra bir yay boyunca çabucak döner.",
    ),
    (
        "Toggle press",
        "Dirsekli pres",
    ),
    (
        "a knuckle-joint press of the textbooks; own dimensions",
        "ders kitaplarındaki dirsekli pres; boyutlar kendimizden",
    ),
    (
        "Near 178 degrees the toggle links r4 and r5 come within one degree of a straight line each: the ram almost rests, and its force grows without bound as they straighten.",
        "178 derece yakınında dirsek uzuvları r4 ve r5 doğrultuya birer dereceye kadar yaklaşır: koç neredeyse durur, uzuvlar doğruldukça kuvveti sınırsız büyür.",
    ),
    (
        "Scissor lift",
        "Makaslı platform",
    ),
    (
        "ten equal stages of crossed bars, the common lifting platform; own dimensions",
        "çapraz çubuklu on eş kat, bilinen kaldırma platformu; boyutlar kendimizden",
    ),
    (
        "Each stage adds the same: the platform at L10 and R10 stands at 20 m times the sine of the bars' angle, and rises fastest while the lift is low.",
        "Her kat aynısını ekler: L10 ve R10 üzerindeki platform, 20 m çarpı çubuk açısının sinüsü yüksekliktedir, alçaktayken en hızlı yükselir.",
    ),
    (
        "Excavator boom",
        "Ekskavatör bomu",
    ),
    (
        "own dimensions, of the size of a 20-tonne excavator",
        "boyutlar kendimizden, 20 tonluk bir ekskavatör kadar",
    ),
    (
        "The input is a cylinder between the machine and the boom: by the geometry it could stretch from 1.65 m to 3.04 m, where it comes into line with the two pins of the machine. Near either end a small stroke turns the boom far.",
        "Giriş, makine ile bom arasındaki bir silindirdir: geometriye göre 1.65 m ile 3.04 m arasında uzayabilir; orada makinenin iki pimiyle aynı doğruya gelir. İki uca yakınken küçük bir strok bomu çok döndürür.",
    ),
    (
        "Parallelogram",
        "Paralelkenar",
    ),
    (
        "The change-point four-bar of every textbook: opposite sides equal; own dimensions",
        "Her ders kitabındaki değişim konumlu dört çubuk: karşı kenarlar eşit; boyutlar kendimizden",
    ),
    (
        "The coupler keeps its direction. At 0 and 180 deg all links lie in one line and the crossed form would be possible too: the motion passes smoothly, and stays a parallelogram.",
        "Biyel yönünü korur. 0 ve 180 deg konumunda bütün uzuvlar bir doğruya gelir, çapraz biçim de olabilirdi: hareket kesintisiz geçer ve paralelkenar kalır.",
    ),
    (
        "Antiparallelogram",
        "Karşıt paralelkenar",
    ),
    (
        "The parallelogram's other assembly, with crossed links; own dimensions",
        "Paralelkenarın öteki montaj biçimi, uzuvları çapraz; boyutlar kendimizden",
    ),
    (
        "The follower turns against the crank, and fastest where the links lie in one line: -2 to 1 at 0 deg, -1 to 2 at 180 deg. The motion passes there and stays crossed.",
        "Çıkış kolu kranka ters döner, uzuvlar bir doğruya gelince en hızlı: 0 deg konumunda 1'e -2, 180 deg konumunda 2'ye -1. Hareket oradan geçer ve çapraz kalır.",
    ),
    (
        "Kite",
        "Uçurtma",
    ),
    (
        "The galloping linkage, a deltoid: two pairs of equal neighbours; own dimensions",
        "Dört nala giden mekanizma, bir deltoit: komşu kenarlar ikişer ikişer eşit; boyutlar kendimizden",
    ),
    (
        "The motion repeats after two turns. Once a turn the crank's pin B meets the pivot D, where the links r3 and r4 lie on each other and could swing about it locked together: the motion passes there.",
        "Hareket iki turda yinelenir. Her turda bir kez krankın pimi B, mesnet D ile buluşur; orada r3 ve r4 üst üstedir ve birlikte onun çevresinde dönebilirdi: hareket oradan geçer.",
    ),
    (
        "Three parallel cranks",
        "Üç paralel krank",
    ),
    (
        "The coupled wheels of a locomotive, drawn as a linkage; own dimensions",
        "Bir lokomotifin bağlı tekerlekleri, mekanizma olarak çizilmiş; boyutlar kendimizden",
    ),
    (
        "One crank more than the motion needs: its length repeats what the others fix, so it only fits if it fits exactly. krank sets it aside and watches it all the way round.",
        "Harekete gerekenden bir krank fazla: boyu ötekilerin belirlediğini yineler, ancak tam uyarsa sığar. krank onu bir yana koyar ve bütün dönüş boyunca gözler.",
    ),
    (
        "Shaper",
        "Vargel tezgâhı",
    ),
    (
        "the slotted-link drive of shaping machines as in the textbooks on machine tools; own dimensions",
        "takım tezgâhları ders kitaplarındaki vargel kulisli mekanizması; boyutlar kendimizden",
    ),
    (
        "The tool cuts while the pin goes the long way over the top and hurries back below: 227 degrees to 133, a time ratio of 1.71. The stroke is 0.8 times the lever, 400 mm.",
        "Pim üstten uzun yoldan giderken takım keser, alttan hızla döner: 227 dereceye karşı 133, zaman oranı 1.71. Strok kolun 0.8 katıdır, 400 mm.",
    ),
    (
        "Knuckle press of two blows",
        "Turda iki vuruşlu mafsallı pres",
    ),
    (
        "the knuckle-joint press of the textbooks on metal forming, set so that the knuckle passes its straight line; own dimensions",
        "metal şekillendirme ders kitaplarının mafsallı presi, mafsal doğru çizgiden geçecek biçimde; boyutlar kendimizden",
    ),
    (
        "The crank swings the knuckle K from one side to the other. The ram is lowest whenever K passes the straight line from O to S: it strikes twice a turn and turns round four times.",
        "Krank, K mafsalını bir yandan öbür yana salındırır. K, O ile S arasındaki doğrudan her geçişte koç en alttadır: bir turda iki kez vurur ve dört kez döner.",
    ),
    (
        "Drag-link press",
        "Çift kranklı pres",
    ),
    (
        "the drag-link drive of deep-drawing presses as in the textbooks on presses; own dimensions",
        "presler üzerine ders kitaplarındaki derin çekme preslerinin çift kranklı tahriki; boyutlar kendimizden",
    ),
    (
        "A double crank turns the second crank unevenly: the ram comes down over 225 degrees of the crank, draws the sheet slowly, and is lifted over 135.",
        "Çift krank ikinci krankı düzgün olmayan hızla döndürür: koç krankın 225 derecesi boyunca iner, sacı yavaş çeker, 135 derecede kalkar.",
    ),
    (
        "V-twin",
        "V iki silindir",
    ),
    (
        "two cylinders at 90 degrees on one crank pin, as in the textbooks on engine balancing; own dimensions",
        "motor dengelemesi ders kitaplarındaki gibi, bir krank piminde 90 derecelik iki silindir; boyutlar kendimizden",
    ),
    (
        "Each piston shakes the frame along its own cylinder; at 90 degrees both together are a force of even size that turns with the crank, and the counterweight takes all of it. What is left comes twice a turn, from the rods' obliquity.",
        "Her piston şaseyi kendi silindiri boyunca sarsar; 90 derecede ikisi birlikte krankla dönen, boyu değişmeyen bir kuvvettir ve karşı ağırlık bunun hepsini alır. Kalan, biyellerin eğikliğinden turda iki kez gelir.",
    ),
    (
        "Radial engine",
        "Yıldız motor",
    ),
    (
        "a five-cylinder radial engine with a master rod, as in the textbooks on aircraft engines; own dimensions",
        "uçak motorları ders kitaplarındaki gibi, ana biyelli beş silindirli bir yıldız motor; boyutlar kendimizden",
    ),
    (
        "One rod is the master: the other four hang on its ring, so their pins go on ovals instead of a circle, and no two of their pistons move quite alike.",
        "Bir biyel ana biyeldir: öteki 4 biyel onun halkasına bağlıdır, pimleri çember yerine ovaller çizer ve pistonlarının hiçbir ikisi tam aynı hareket etmez.",
    ),
    (
        "Windscreen wiper",
        "Cam sileceği",
    ),
    (
        "the drive of two blades in the same direction as in the textbooks on mechanisms; own dimensions",
        "mekanizma ders kitaplarındaki, iki sileceği aynı yöne süren tahrik; boyutlar kendimizden",
    ),
    (
        "The crank-rocker is centric: 282.5^2 + 50^2 is 280^2 + 62.5^2, so there and back take the same time. Both blades sweep twice asin(50 / 62.5), 106.26 degrees.",
        "Krank-sarkaç merkezcildir: 282.5^2 + 50^2 ile 280^2 + 62.5^2 eşittir, gidiş ve dönüş aynı süreyi alır. İki silecek de 2 asin(50 / 62.5), yani 106.26 derece süpürür.",
    ),
    (
        "Double wishbone",
        "Çift salıncaklı askı",
    ),
    (
        "the front view of a double-wishbone suspension as in the textbooks on vehicle dynamics; own dimensions",
        "taşıt dinamiği ders kitaplarındaki çift salıncaklı askının önden görünüşü; boyutlar kendimizden",
    ),
    (
        "The upper arm is shorter than the lower one, so the wheel leans inwards as it rises: camber goes with the wheel's travel. Spring and damper stand on the lower arm.",
        "Üst salıncak alttakinden kısadır, bu yüzden tekerlek yükseldikçe içe yatar: kamber açısı tekerleğin yoluyla değişir. Yay ve amortisör alt salıncağa basar.",
    ),
    (
        "Ackermann steering",
        "Ackermann direksiyonu",
    ),
    (
        "the steering trapezium of R. Ackermann (1818) and C. Jeantaud (1878), as in the textbooks on vehicle dynamics; own dimensions",
        "R. Ackermann (1818) ve C. Jeantaud (1878) direksiyon yamuğu, taşıt dinamiği ders kitaplarındaki gibi; boyutlar kendimizden",
    ),
    (
        "The steering arms meet 1.75 m behind the front axle, and the rear axle lies at 2.55 m: so the inner wheel turns further than the outer one. Were all wheels to roll about one point, the error would be 0. It is so straight ahead and near 29.6 degrees, and within 0.3 degrees between.",
        "Deveboynu kolları ön dingilin 1.75 m arkasında buluşur, arka dingil 2.55 m arkadadır: iç tekerlek dıştakinden çok döner. Bütün tekerlekler bir nokta çevresinde yuvarlansaydı hata 0 olurdu. Düz giderken ve 29.6 derece dolayında öyledir, arada 0.3 derece içinde kalır.",
    ),
    (
        "Backhoe bucket",
        "Kazıcı kepçesi",
    ),
    (
        "the bucket linkage of a backhoe loader, by the proportions of makers' drawings; own dimensions",
        "bir kazıcı yükleyicinin kepçe mekanizması, üretici çizimlerinin oranlarıyla; boyutlar kendimizden",
    ),
    (
        "The cylinder pushes a rocker on the dipper, and a link turns the bucket further than the rocker: a short cylinder empties it and curls it in.",
        "Silindir bom kolundaki bir sarkacı iter, bir uzuv kepçeyi sarkaçtan daha çok döndürür: kısa bir silindir kepçeyi boşaltır ve içeri kıvırır.",
    ),
    (
        "Scissor lift table",
        "Makaslı kaldırma masası",
    ),
    (
        "a lift table with its cylinder between the arms, as makers' leaflets draw it; own dimensions",
        "silindiri kollarının arasında olan bir kaldırma masası, üretici broşürlerindeki gibi; boyutlar kendimizden",
    ),
    (
        "The cylinder works between the two arms, so nothing can be found by itself: arms, barrel and foot are solved together. The flatter the table lies, the harder the cylinder must push.",
        "Silindir iki kolun arasında çalışır, hiçbir şey tek başına bulunamaz: kollar, silindir gövdesi ve ayak birlikte çözülür. Masa ne kadar alçaksa silindir o kadar çok iter.",
    ),
    (
        "Hatch",
        "Kapak",
    ),
    (
        "Logarithm",
        "Logaritma",
    ),
    (
        "Straight-line guide",
        "Doğru çizen mekanizma",
    ),
    (
        "Stirrer",
        "Karıştırıcı",
    ),
];
