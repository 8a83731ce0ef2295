//! Turkish translations of the titles, sources and notes in the built-in scenes, and of the titles
//! of the built-in tasks. A changed text has no translation and is shown as it is.

/// Returns the translation of a text in a built-in scene, or any other text unchanged.
pub(super) fn said(text: &str) -> &str {
    let known = TEXTS.iter().find(|(english, _)| *english == text);
    known.map_or(text, |(_, turkish)| turkish)
}

#[rustfmt::skip]
const TEXTS: [(&str, &str); 117] = [
    (
        "Four-bar crank-rocker",
        "Dört çubuk, krank-sarkaç",
    ),
    (
        "lecture on machine dynamics, weeks 3 and 7: position and acceleration analysis",
        "makine dinamiği dersi, 3. ve 7. hafta: konum ve ivme analizi",
    ),
    (
        "The crank r2 turns fully, and the rocker r4 swings. At 60 deg the tables show every value of the lecture.",
        "Krank r2 tam döner, sarkaç r4 salınır. 60 deg konumunda tablolar dersin bütün değerlerini gösterir.",
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
        "The slider C is fastest shortly before the crank is perpendicular to the rod, not at 90 deg.",
        "Kızak C, 90 deg konumunda değil, krank biyele dik olmadan biraz önce en hızlıdır.",
    ),
    (
        "Press of two four-bars",
        "İki dört çubuklu pres",
    ),
    (
        "a press of two loops as in a lecture's homework on position analysis; dimensions chosen for krank",
        "konum analizi ödevindeki gibi iki döngülü bir pres; boyutlar krank için seçildi",
    ),
    (
        "One crank moves two loops in series: the bell crank r4 is the rocker of the first four-bar (it swings by 48 degrees) and the crank of the second.",
        "Tek krank art arda iki döngüyü hareket ettirir: dirsekli kol r4 birinci dört çubuğun sarkacı (48 derece salınır), ikincinin krankıdır.",
    ),
    (
        "Press with a ram",
        "Koçlu pres",
    ),
    (
        "the drive of the press of two four-bars, ended by a vertical ram; dimensions chosen for krank",
        "iki dört çubuklu presin tahriki, ucunda düşey bir koçla; boyutlar krank için seçildi",
    ),
    (
        "The bell crank r4 swings and moves the ram down and up. The ram is a link that slides without turning, so the tool below its pin keeps its direction.",
        "Dirsekli kol r4 salındıkça koç inip çıkar. Koç dönmeden kayan bir uzuvdur; piminin altındaki takım yönünü korur.",
    ),
    (
        "Four-bar that lifts a load",
        "Yük kaldıran dört çubuk",
    ),
    (
        "lecture on machine dynamics, week 3: 500 N against the motor's torque; masses chosen for krank",
        "makine dinamiği dersi, 3. hafta: 500 N, motorun torkuna karşı; kütleler krank için seçildi",
    ),
    (
        "A load of 500 N hangs from the rocker of the lecture's four-bar. The motor lifts the load, and the load drives the motor back. At 15 rad/s the inertia of the links matters too. The crank is balanced: its centre of mass is its pivot.",
        "Dersin dört çubuğunun sarkacına 500 N'luk bir yük asılıdır. Motor yükü kaldırır, yük de motoru geri sürer. 15 rad/s hızda uzuvların ataleti de önemlidir. Krank dengelidir: ağırlık merkezi mesnetindedir.",
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
        "The gas drives the piston during one of four strokes, from 0 deg; the fourth stroke begins at 540. The torque therefore repeats after 720 deg, the linkage after 360. During the power stroke the gas force far exceeds all inertia forces; during the other three it is far smaller.",
        "Gaz, pistonu dört stroktan birinde, 0 deg konumundan başlayarak iter; dördüncü strok 540 deg konumunda başlar. Bu yüzden tork 720 deg, mekanizma 360 deg sonra yinelenir. İş strokunda gaz kuvveti bütün atalet kuvvetlerinden çok büyük, öteki üçünde çok küçüktür.",
    ),
    (
        "Offset slider-crank",
        "Kaçık krank-biyel",
    ),
    (
        "a textbook quick-return slider-crank; dimensions chosen for krank, rod > crank + offset",
        "ders kitaplarındaki çabuk dönüşlü krank-biyel; boyutlar krank için seçildi, biyel > krank + kaçıklık",
    ),
    (
        "The guide is 50 mm below the crank's pivot. The two strokes therefore take different times: 200.5 and 159.5 degrees of the crank, a time ratio of 1.26.",
        "Kılavuz, krankın mesnetinden 50 mm aşağıdadır. İki strok bu yüzden farklı sürer: krankın 200.5 ve 159.5 derecesi, zaman oranı 1.26.",
    ),
    (
        "Slotted lever",
        "Yarıklı kol",
    ),
    (
        "a textbook crank and slotted lever quick return (an inverted slider-crank); dimensions chosen for krank",
        "ders kitaplarındaki yarıklı kollu çabuk dönüş (evrik krank-biyel); boyutlar krank için seçildi",
    ),
    (
        "The crank's pin drives the lever through a slot. The lever swings by 24.6 degrees to each side. It is fast while the pin is below the crank's pivot.",
        "Krankın pimi kolu bir yarıktan sürer. Kol iki yana 24.6 derece salınır. Pim krankın mesnetinin altındayken hızlıdır.",
    ),
    (
        "Whitworth quick return",
        "Whitworth çabuk dönüşü",
    ),
    (
        "J. Whitworth's quick return for shapers, as in textbooks; dimensions chosen for krank",
        "J. Whitworth'un vargel tezgâhları için çabuk dönüşü, ders kitaplarındaki gibi; boyutlar krank için seçildi",
    ),
    (
        "The lever's pivot is inside the crank's circle, so the lever turns fully, but not uniformly. The tool cuts slowly in one direction and returns quickly (time ratio 2).",
        "Kolun mesneti krankın çemberinin içindedir; kol tam döner, ama düzgün değil. Takım bir yönde yavaş keser ve çabuk döner (zaman oranı 2).",
    ),
    (
        "Scotch yoke",
        "İskoç boyunduruğu",
    ),
    (
        "a textbook double slider; dimensions chosen for krank",
        "ders kitaplarındaki çift kızaklı mekanizma; boyutlar krank için seçildi",
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
        "P. L. Chebyshev's straight-line linkage: frame : rockers : coupler = 4 : 5 : 2",
        "P. L. Chebyshev'in doğru çizen mekanizması: şase : sarkaçlar : biyel = 4 : 5 : 2",
    ),
    (
        "Neither rocker can turn fully: the driven one swings from acos(4/5), 36.87 degrees, to acos(-1/5), 101.54 degrees. Between these ends, P on the coupler follows an almost straight line.",
        "İki sarkaç da tam dönemez: tahrik edilen acos(4/5), 36.87 derece ile acos(-1/5), 101.54 derece arasında salınır. Bu uçların arasında biyelin P noktası neredeyse bir doğru çizer.",
    ),
    (
        "Drag link",
        "Çift krank (sürükleyici)",
    ),
    (
        "a Grashof double crank as in textbooks; dimensions chosen for krank, frame : crank : coupler : crank = 1 : 2 : 2.5 : 2.2",
        "ders kitaplarındaki Grashof çift krankı; boyutlar krank için seçildi, şase : krank : biyel : krank = 1 : 2 : 2.5 : 2.2",
    ),
    (
        "The shortest link is the frame, so both cranks turn fully. The driver turns at constant speed, and the other crank speeds up and slows down.",
        "En kısa uzuv şasedir, bu yüzden iki krank da tam döner. Tahrik sabit hızla döner, öteki krank hızlanır ve yavaşlar.",
    ),
    (
        "Watt's six-bar",
        "Watt'ın altı çubuğu",
    ),
    (
        "Watt's second six-bar chain (two four-bars that share a ternary rocker), in the notation of textbooks; dimensions chosen for krank",
        "Watt'ın ikinci altı çubuk zinciri (üç mafsallı sarkacı ortak iki dört çubuk), ders kitaplarının gösterimiyle; boyutlar krank için seçildi",
    ),
    (
        "The frame and r4 are ternary links. The arm E of r4 transmits the swing of the first four-bar, 45 degrees, to the rocker r6 of the second.",
        "Şase ve r4 üç mafsallı uzuvlardır. r4 uzvunun E kolu, birinci dört çubuğun 45 derecelik salınımını ikincinin sarkacı r6 uzvuna iletir.",
    ),
    (
        "Stephenson's six-bar, driven across its loops",
        "Stephenson'ın altı çubuğu, döngülerin karşısından tahrikli",
    ),
    (
        "Stephenson's six-bar of type III, driven at the side of the dyad; dimensions chosen for krank",
        "Stephenson'ın III. tür altı çubuğu, ikili grubun yanından tahrikli; boyutlar krank için seçildi",
    ),
    (
        "No dyad can be solved alone: three links carry the ternary coupler r4 together (an Assur group of class III). krank solves all of them together by Newton's method.",
        "Hiçbir ikili grup tek başına çözülemez: üç uzuv, üç mafsallı biyel r4 uzvunu birlikte taşır (III. sınıf Assur grubu). krank hepsini birlikte Newton yöntemiyle çözer.",
    ),
    (
        "Jansen's walking leg",
        "Jansen'in yürüyen bacağı",
    ),
    (
        "Theo Jansen's Strandbeest: his 'holy numbers' a to m (The Great Pretender, 2007), in cm",
        "Theo Jansen'in Strandbeest'i: a'dan m'ye 'kutsal sayıları' (The Great Pretender, 2007), cm olarak",
    ),
    (
        "Eight links change the rotation of one crank into a step: the foot T stays on the ground for more than half a turn and is lifted for the rest.",
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
        "The foot moves along an almost horizontal line for almost half a turn of the crank and is lifted for the rest. The body would move to the right.",
        "Ayak, krankın neredeyse yarım turu boyunca hemen hemen yatay bir çizgide ilerler, geri kalanda kalkar. Gövde sağa giderdi.",
    ),
    (
        "Peaucellier's cell",
        "Peaucellier hücresi",
    ),
    (
        "C.-N. Peaucellier's inversor (1864): long arms 100, rhombus 40, so that OB times OD is 100^2 - 40^2; dimensions chosen for krank",
        "C.-N. Peaucellier'in evirteci (1864): uzun kollar 100, eşkenar dörtgen 40, böylece OB çarpı OD 100^2 - 40^2; boyutlar krank için seçildi",
    ),
    (
        "Seven links draw an exact straight line: P stays at x = 105 exactly, because B is on a circle through O. The motion ends where the rhombus folds, at 82.82 degrees to each side.",
        "Yedi uzuv tam bir doğru çizer: P tam x = 105 üzerinde kalır, çünkü B, O noktasından geçen bir çember üzerindedir. Hareket, eşkenar dörtgenin kapandığı yerde, iki yana 82.82 derecede biter.",
    ),
    (
        "Hoecken's straight-line linkage",
        "Hoecken'in doğru çizen mekanizması",
    ),
    (
        "after K. Hoecken: frame : crank : coupler : rocker = 2 : 1 : 2.5 : 2.5, the coupler extended to twice its length",
        "K. Hoecken'e göre: şase : krank : biyel : sarkaç = 2 : 1 : 2.5 : 2.5, biyel iki katı boya uzatılmış",
    ),
    (
        "P follows an almost straight line at almost constant speed for half a turn of the crank, from 90 to 270 degrees. It then returns quickly along an arc.",
        "P, krankın yarım turu boyunca, 90 dereceden 270 dereceye, neredeyse sabit hızla neredeyse bir doğru çizer. Sonra bir yay boyunca çabuk döner.",
    ),
    (
        "Toggle press",
        "Dirsekli pres",
    ),
    (
        "a textbook knuckle-joint press; dimensions chosen for krank",
        "ders kitaplarındaki dirsekli pres; boyutlar krank için seçildi",
    ),
    (
        "Near 178 degrees the toggle links r4 and r5 are each within one degree of a straight line. The ram almost dwells, and its force grows without bound as they straighten.",
        "178 derece yakınında dirsek uzuvları r4 ve r5 doğrultuya birer derece yaklaşır. Koç neredeyse durur, uzuvlar doğruldukça kuvveti sınırsız büyür.",
    ),
    (
        "Scissor lift",
        "Makaslı platform",
    ),
    (
        "ten equal stages of crossed bars, as in lifting platforms; dimensions chosen for krank",
        "çapraz çubuklu on eş kat, kaldırma platformlarındaki gibi; boyutlar krank için seçildi",
    ),
    (
        "Each stage adds the same height: the platform at L10 and R10 is 20 m times the sine of the bars' angle high. It rises fastest while the lift is low.",
        "Her kat aynı yüksekliği ekler: L10 ve R10 üzerindeki platformun yüksekliği 20 m çarpı çubuk açısının sinüsüdür. Platform alçaktayken en hızlı yükselir.",
    ),
    (
        "Excavator boom",
        "Ekskavatör bomu",
    ),
    (
        "dimensions chosen for krank, about those of a 20-tonne excavator",
        "boyutlar krank için seçildi, yaklaşık olarak 20 tonluk bir ekskavatörünkiler",
    ),
    (
        "The input is a cylinder between the machine and the boom. The geometry limits its length to 1.65 m and 3.04 m: there it lies in one line with the two pins of the machine. Near these ends a small stroke turns the boom by a large angle.",
        "Giriş, makine ile bom arasındaki bir silindirdir. Geometri, boyunu 1.65 m ve 3.04 m ile sınırlar: orada makinenin iki pimiyle aynı doğruya gelir. Bu uçların yakınında küçük bir strok bomu büyük bir açıyla döndürür.",
    ),
    (
        "Parallelogram",
        "Paralelkenar",
    ),
    (
        "the change-point four-bar of every textbook: opposite sides are equal; dimensions chosen for krank",
        "her ders kitabındaki değişim konumlu dört çubuk: karşı kenarlar eşit; boyutlar krank için seçildi",
    ),
    (
        "The coupler keeps its direction. At 0 and 180 deg all links lie in one line, and the crossed assembly would be possible too. The motion passes smoothly and stays a parallelogram.",
        "Biyel yönünü korur. 0 ve 180 deg konumunda bütün uzuvlar bir doğruya gelir, çapraz montaj biçimi de olabilirdi. Hareket kesintisiz geçer ve paralelkenar kalır.",
    ),
    (
        "Antiparallelogram",
        "Karşıt paralelkenar",
    ),
    (
        "the other assembly of the parallelogram, with crossed links; dimensions chosen for krank",
        "paralelkenarın öteki montaj biçimi, uzuvları çapraz; boyutlar krank için seçildi",
    ),
    (
        "The follower turns in the opposite direction to the crank. Where the links lie in one line, its speed is -2 times that of the crank at 0 deg, and -1/2 times at 180 deg. The motion passes there and stays crossed.",
        "Çıkış kolu kranka ters döner. Uzuvların bir doğruya geldiği yerde hızı, 0 deg konumunda krankınkinin -2 katı, 180 deg konumunda -1/2 katıdır. Hareket oradan geçer ve çapraz kalır.",
    ),
    (
        "Kite",
        "Uçurtma",
    ),
    (
        "the galloping linkage, a deltoid: two pairs of equal adjacent links; dimensions chosen for krank",
        "dört nala giden mekanizma, bir deltoit: komşu uzuvlar ikişer ikişer eşit; boyutlar krank için seçildi",
    ),
    (
        "The motion repeats after two turns. Once a turn the crank's pin B coincides with the pivot D. The links r3 and r4 then lie on each other and could turn about D together. The motion passes this change point.",
        "Hareket iki turda yinelenir. Her turda bir kez krankın pimi B, mesnet D ile çakışır. Orada r3 ve r4 üst üstedir ve birlikte D çevresinde dönebilirdi. Hareket bu değişim konumundan geçer.",
    ),
    (
        "Three parallel cranks",
        "Üç paralel krank",
    ),
    (
        "the coupled wheels of a locomotive as a linkage; dimensions chosen for krank",
        "bir lokomotifin bağlı tekerlekleri, mekanizma olarak; boyutlar krank için seçildi",
    ),
    (
        "The linkage has one crank more than its motion needs. This crank is a redundant constraint and fits only if its length is exact. krank sets the constraint aside and monitors it over the whole turn.",
        "Mekanizmanın, hareketinin gerektirdiğinden bir krankı fazladır. Bu krank fazla bir kısıttır ve ancak boyu tam ise uyar. krank bu kısıtı ayırır ve bütün tur boyunca izler.",
    ),
    (
        "Shaper",
        "Vargel tezgâhı",
    ),
    (
        "the slotted-link drive of shaping machines as in textbooks on machine tools; dimensions chosen for krank",
        "takım tezgâhları ders kitaplarındaki vargel kulisli mekanizması; boyutlar krank için seçildi",
    ),
    (
        "The tool cuts while the pin takes the long upper arc, and returns during the short lower one: 227 and 133 degrees, a time ratio of 1.71. The stroke is 0.8 times the lever's length, 400 mm.",
        "Pim uzun üst yaydayken takım keser, kısa alt yayda geri döner: 227 ve 133 derece, zaman oranı 1.71. Strok, kol boyunun 0.8 katıdır, 400 mm.",
    ),
    (
        "Knuckle press of two blows",
        "Turda iki vuruşlu mafsallı pres",
    ),
    (
        "a knuckle-joint press as in textbooks on metal forming, with a knuckle that passes its straight position; dimensions chosen for krank",
        "metal şekillendirme ders kitaplarındaki gibi bir mafsallı pres, mafsalı doğru konumundan geçer; boyutlar krank için seçildi",
    ),
    (
        "The crank moves the knuckle K from one side to the other. The ram is lowest whenever K passes the straight line from O to S. It therefore strikes twice a turn and reverses four times.",
        "Krank, K mafsalını bir yandan öteki yana götürür. K, O ile S arasındaki doğrudan her geçişte koç en alttadır. Bu yüzden bir turda iki kez vurur ve dört kez yön değiştirir.",
    ),
    (
        "Drag-link press",
        "Çift kranklı pres",
    ),
    (
        "the drag-link drive of deep-drawing presses as in textbooks on presses; dimensions chosen for krank",
        "presler üzerine ders kitaplarındaki derin çekme preslerinin çift kranklı tahriki; boyutlar krank için seçildi",
    ),
    (
        "A double crank turns the second crank at varying speed. The ram moves down during 225 degrees of the crank, draws the sheet slowly, and rises during 135.",
        "Çift krank ikinci krankı değişen hızla döndürür. Koç krankın 225 derecesi boyunca iner, sacı yavaş çeker, 135 derecede kalkar.",
    ),
    (
        "V-twin",
        "V iki silindir",
    ),
    (
        "two cylinders at 90 degrees on one crank pin, as in textbooks on engine balancing; dimensions chosen for krank",
        "motor dengelemesi ders kitaplarındaki gibi, bir krank piminde 90 derecelik iki silindir; boyutlar krank için seçildi",
    ),
    (
        "Each piston shakes the frame along its own cylinder. At 90 degrees, the sum of both is a force of constant magnitude that turns with the crank, and the counterweight balances it. The rest has twice the frequency and comes from the obliquity of the rods.",
        "Her piston şaseyi kendi silindiri boyunca sarsar. 90 derecede ikisinin toplamı, krankla dönen sabit büyüklükte bir kuvvettir ve karşı ağırlık onu dengeler. Kalanın frekansı iki katıdır ve biyellerin eğikliğinden gelir.",
    ),
    (
        "Radial engine",
        "Yıldız motor",
    ),
    (
        "a five-cylinder radial engine with a master rod, as in textbooks on aircraft engines; dimensions chosen for krank",
        "uçak motorları ders kitaplarındaki gibi, ana biyelli beş silindirli bir yıldız motor; boyutlar krank için seçildi",
    ),
    (
        "One rod is the master rod. The other four are pinned to its ring, so their pins move on ovals instead of a circle. No two of their pistons have exactly the same motion.",
        "Bir biyel ana biyeldir. Öteki dördü onun halkasına bağlıdır, bu yüzden pimleri çember yerine ovaller çizer. Pistonlarının hiçbir ikisi tam aynı hareketi yapmaz.",
    ),
    (
        "Windscreen wiper",
        "Cam sileceği",
    ),
    (
        "the drive of two blades in the same direction as in textbooks on mechanisms; dimensions chosen for krank",
        "mekanizma ders kitaplarındaki, iki sileceği aynı yöne süren tahrik; boyutlar krank için seçildi",
    ),
    (
        "The crank-rocker is centric: 282.5^2 + 50^2 = 280^2 + 62.5^2, so both strokes take the same time. Both blades sweep 2 asin(50 / 62.5) = 106.26 degrees.",
        "Krank-sarkaç merkezcildir: 282.5^2 + 50^2 = 280^2 + 62.5^2; gidiş ve dönüş aynı süreyi alır. İki silecek de 2 asin(50 / 62.5) = 106.26 derece süpürür.",
    ),
    (
        "Double wishbone",
        "Çift salıncaklı askı",
    ),
    (
        "the front view of a double-wishbone suspension, as in textbooks on vehicle dynamics; dimensions chosen for krank",
        "taşıt dinamiği ders kitaplarındaki çift salıncaklı askının önden görünüşü; boyutlar krank için seçildi",
    ),
    (
        "The upper arm is shorter than the lower one, so the wheel leans inwards as it rises: the camber depends on the travel. The spring and the damper act on the lower arm.",
        "Üst salıncak alttakinden kısadır, bu yüzden tekerlek yükseldikçe içe yatar: kamber açısı tekerleğin yoluna bağlıdır. Yay ve amortisör alt salıncağa etki eder.",
    ),
    (
        "Ackermann steering",
        "Ackermann direksiyonu",
    ),
    (
        "the steering trapezium of R. Ackermann (1818) and C. Jeantaud (1878), as in textbooks on vehicle dynamics; dimensions chosen for krank",
        "R. Ackermann (1818) ve C. Jeantaud (1878) direksiyon yamuğu, taşıt dinamiği ders kitaplarındaki gibi; boyutlar krank için seçildi",
    ),
    (
        "The lines of the steering arms meet 1.75 m behind the front axle; the rear axle is at 2.55 m. The inner wheel therefore turns further than the outer one. The error is 0 if all wheels roll about one point: straight ahead and near 29.6 degrees. Between these it is at most 0.3 degrees.",
        "Deveboynu kollarının doğruları ön dingilin 1.75 m arkasında buluşur; arka dingil 2.55 m arkadadır. Bu yüzden iç tekerlek dıştakinden çok döner. Bütün tekerlekler bir nokta çevresinde yuvarlanırsa hata 0 olur: düz giderken ve 29.6 derece yakınında. Bunların arasında hata en çok 0.3 derecedir.",
    ),
    (
        "Backhoe bucket",
        "Kazıcı kepçesi",
    ),
    (
        "the bucket linkage of a backhoe loader, in the proportions of manufacturers' drawings; dimensions chosen for krank",
        "bir kazıcı yükleyicinin kepçe mekanizması, üretici çizimlerinin oranlarıyla; boyutlar krank için seçildi",
    ),
    (
        "The cylinder pushes a rocker on the dipper, and a link turns the bucket further than the rocker. A short cylinder can therefore empty the bucket and curl it in.",
        "Silindir bom kolundaki bir sarkacı iter, bir uzuv kepçeyi sarkaçtan daha çok döndürür. Bu yüzden kısa bir silindir kepçeyi boşaltabilir ve içeri kıvırabilir.",
    ),
    (
        "Scissor lift table",
        "Makaslı kaldırma masası",
    ),
    (
        "a lift table with its cylinder between the arms, as in manufacturers' catalogues; dimensions chosen for krank",
        "silindiri kollarının arasında olan bir kaldırma masası, üretici kataloglarındaki gibi; boyutlar krank için seçildi",
    ),
    (
        "The cylinder acts between the two arms, so no part can be solved alone: krank solves the arms, the barrel and the foot together. The lower the table, the larger the force of the cylinder.",
        "Silindir iki kolun arasında etki eder, hiçbir parça tek başına çözülemez: krank kolları, silindir gövdesini ve ayağı birlikte çözer. Masa ne kadar alçaksa silindirin kuvveti o kadar büyüktür.",
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
    (
        "Five-bar of two motors",
        "İki motorlu beş çubuk",
    ),
    (
        "dimensions chosen for krank; the base of 120 and the arms of 100 and 140 are those of a common exercise",
        "boyutlar krank için seçildi; 120 taban ile 100 ve 140 kollar, yaygın bir alıştırmanın ölçüleri",
    ),
    (
        "Two motors on the ground move the point P in the plane. One of them moves while the other is held: the inputs r2 and r5.",
        "Şasedeki iki motor P noktasını düzlemde hareket ettirir. Biri hareket ederken öteki tutulur: r2 ve r5 girişleri.",
    ),
    (
        "Robot arm of two motors",
        "İki motorlu robot kolu",
    ),
    (
        "The motor of the shoulder is on the ground, and that of the elbow on the upper arm. Each holds the weight of the arm while the other one moves.",
        "Omuz motoru şasede, dirsek motoru üst koldadır. Biri hareket ederken öteki kolun ağırlığını tutar.",
    ),
    (
        "Excavator with three cylinders",
        "Üç silindirli ekskavatör",
    ),
    (
        "The cylinders of boom, arm and bucket are three inputs. The boom's cylinder moves while the other two are held at their lengths.",
        "Bom, kol ve kepçe silindirleri üç giriştir. Bom silindiri hareket ederken öteki ikisi kendi boylarında tutulur.",
    ),
    (
        "dimensions chosen for krank",
        "boyutlar krank için seçildi",
    ),
];
