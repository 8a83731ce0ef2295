//! Text below the options in the help of each command: examples and notes.

use super::Turkish;
use crate::wording::english::ExamplesWords;

catalogue! {
    impl ExamplesWords for Turkish {
        keys_of_workbench = "\
Tezgâhın tuşları:
  space oynat, durdur   . bir adım ileri  , bir adım geri   r ters yön
  g bir konuma git      2 bütün tablolar  n sonraki sahne   t diğer karakterler
  a diğer montajlar     ? bütün tuşlar    q çık

";
        examples_of_krank = "\
Örnekler:
  krank                          derslerdeki dört çubuğu açın
  krank slider-crank --at 30     hazır bir sahneyi 30 derecede açın
  krank my-press.toml            bir sahne dosyasını açın
  krank press --view tables      hazır bir sahneyi bütün tablolarıyla açın
  krank press --print            açılan ekranı yazın ve çıkın
  krank sweep four-bar -o four-bar.csv

SCENE bir dosya, hazır bir sahnenin adı (krank list) ya da standart girdi için -
olur. İçinde / olan ya da .toml ile biten ad her zaman dosyadır: ./four-bar.

krank help el kitabının konularını listeler: sahne dosyası, tuşlar, sütunlar vb.
krank completions SHELL ve krank man tamamlama betiği ve man sayfası yazar.

Çıkış kodları: 0 tamam; 1 mekanizma isteneni yapamaz ya da çıktı yazılamaz;
2 komut satırı ya da sahne geçersiz.";
        examples_of_list = "\
Örnek:
  krank list                     hazır sahnelerin adları ve başlıkları";
        examples_of_check = "\
Örnekler:
  krank check four-bar
  krank check four-bar --assembly C=-
  krank check my-press.toml --format json
  krank check - < my-press.toml";
        examples_of_table = "\
Örnekler:
  krank table four-bar --at 60
  krank table slider-crank --at 30 --digits 10
  krank table press --bounds --sensitivity
  krank table four-bar-load --bounds
  krank table four-bar --columns 'C.a*,swing = r4.angle - r3.angle' --bounds
  krank table four-bar --format json
  krank table four-bar --format csv --decimal comma -o tablo.csv
  krank table four-bar --at 240 --assembly C=-";
        examples_of_explain = "\
Örnekler:
  krank explain four-bar --at 60
  krank explain slider-crank --at 30 --digits 9
  krank explain press -o press.md
  krank explain four-bar --method newton --guess r3=20,r4=280
  krank explain four-bar --method bisection --guess r3=0..90

Vektörel poligonlar, konum tablosu, bileşenleriyle ve izdüşümleriyle vektörel
konum denklemleri, her grubun çözümü, türevi alınmış denklemlerle hızlar ve
ivmeler, mafsallar ve ağırlık merkezleri teğetsel ve merkezcil bileşenleriyle, bir
de sağlama. Her satır kendi formülüyle, önceki satırların değerlerinden hesaplanır;
bağlaşık bir grubun denklemleri ve çözümü gösterilir, yok etme adımları değil. Yük,
yay ya da kütle varsa her uzvun ve yüklü pimin dengesi tepki kuvvetleriyle verilir,
tahrikin kuvveti ya da torku sanal işle sağlanır. Ölü konumda yalnız konumlar
vardır. Aralığın dışında yalnız döngüler ve verilenler yazılır, çıkış kodu 1 olur.
Terminalde ya da yerel ayarda Yunan harfleri yoksa adlarıyla yazılır.";
        examples_of_draw = "\
Örnekler:
  krank draw four-bar --at 60
  krank draw hoecken --traces
  krank draw four-bar --velocities --accelerations C --size 120x40
  krank draw jansen-leg --traces T --ghosts 6 -o leg.svg
  krank draw slider-crank --scale 1:2 -o print.svg
  krank draw four-bar --traces C -o four-bar.dxf

POINTS virgülle ayrılmış nokta adları ya da all olur. Ad verilmezse --traces, sabit
bir mafsal çevresindeki çemberler dışındaki eğrileri (başka eğri yoksa onları),
--velocities
ve --accelerations bütün mafsal ve uzuv noktalarının oklarını, --forces yüklerin,
mafsalların, kılavuzların ve tahrikin oklarını büyüklükleriyle çizer. Aynı türden
okların ölçeği bütün harekette birdir; alttaki satırda yazar. Gövdesi kesik olan
ok, çizildiğinden uzundur.";
        examples_of_export = "\
Örnekler:
  krank export four-bar -o four_bar.py
  python3 four_bar.py 0 360 10
  krank export press-ram -o press_ram.m
  octave --eval 'press_ram(0, 360, 10)'

Betik her boyu adıyla tanımlar, her grubu bir satırda, formülleri tam olarak çözer
ve krank'ı gerektirmez. Başlangıcı, sonu ve adımı alır, krank sweep sütunlarını
yazar; MATLAB ve Octave'da [rows, heads] = press_ram(0, 360, 10) bunları döndürür.
Her grup montaj biçimini koruduğu sürece betikte bir boyu değiştirebilirsiniz.
CAD çizimi için krank draw --format dxf, değerler için krank sweep kullanın.";
        examples_of_import = "\
Örnekler:
  krank import fourbar.txt -o fourbar.toml
  krank import leg.linkage2 | krank check -
  krank leg.linkage2
  krank import 'https://designengrlab.github.io/PMKS/pmks.html?mech=...' -o bar.toml

Biçim içeriğinden tanınır: PMKS metni ya da adresi, j= ve l= içeren bir PMKS+
adresi, Linkage'in XML'i, bir Pyslvs ifadesi ya da pylinkage'in JSON'u. Sahne alan
her komut böyle bir dosyayı doğrudan okur. Dişliler ve krank'ın modellemediği
başka parçalar dosyadaki yerleriyle bildirilir; kalanı alınır. Sahne çizimin
konumunda açılır.";
        examples_of_sweep = "\
Örnekler:
  krank sweep four-bar --from 0 --to 360 --step 1 --columns C.x,C.vx,r4.omega
  krank sweep four-bar --columns 'C.*,*.omega' --format json
  krank sweep four-bar --decimal comma -o tablo.csv
  krank sweep press-ram --step 0.1 -o press.csv

Sütunların adı C.x, C.vy, r3.angle, r3.omega, r4.length, r3.com.ax gibidir;
krank sweep SCENE | head -n 1 bir sahnenin bütün sütunlarını listeler. Yük, yay ya
da kütle varsa driver.torque, driver.power, r3.B.fx (r3 uzvuna B piminde gelen kuvvet),
r4.normal, r6.moment, ground.fx ve yuvarlama olmasa sıfır olacak iki sağlamanın
artıkları da vardır. Tahrikin koordinatı hep ilk, state hep son sütundur: ok,
change-point, dead-point ya da no-assembly. Olmayan değer boş hücredir (JSON: null).
--decimal comma, Türkçe hesap tablolarının açtığı CSV yazar: 15,5 ve ayırıcı ;.
--bounds her C.x sonrasına aynı birimde C.x.bound ekler: sahne verildiği gibi
çözülürken oluşan hatanın sınırı. --sensitivity C.x.sensitivity ekler: verilen her
boy bir birim yanlış olursa C.x değerindeki en büyük değişim.
--from ve --to yoksa tarama bütün hareketi kapsar, sınırlarında ya da bir periyot
sonra biter; kuvvetler varsa yüklerin periyodunda.";
        examples_of_plot = "\
Örnekler:
  krank plot four-bar --columns r4.omega
  krank plot four-bar --columns 'C.v*,r4.alpha' --size 120x40
  krank plot slider-crank --columns C.vx --against C.x
  krank plot hoecken --columns P.y --against P.x -o curve.svg

Sütun adları krank sweep komutundaki gibidir; her birimin kendi paneli olur. Zamana
göre 0 s sahnenin açıldığı konumdur, tahrik oradan kendi hızı ve ivmesiyle sürer. En
büyük ve en küçük değerler konumlarıyla işaretlenir; bunlar resimden okunmaz,
hesaplanır: değer yuvarlamaya, konum yaklaşık 1e-5 deg'e kadar. Değer yoksa boşluk
olur.";
        examples_of_cycle = "\
Örnekler:
  krank cycle whitworth
  krank cycle four-bar --columns C.x,r4.angle
  krank cycle toggle-press --columns S.y --dwell 0.5
  krank cycle slider-crank --columns 'F = C.x * cos(30 deg) + C.y * sin(30 deg)'
  krank cycle jansen-leg -o cycle.csv

Her büyüklük için strok, açılar için salınım; geri döndüğü her yer, çözülerek; uç
konumlar arasında zaman oranı, yavaş / hızlı; bir dönüş yerine --dwell içinde kaldığı
yerler; sahnenin hızında en büyük hızı ve ivmesi. Sonra her ikili grubun bağlama
açısının 90 dereceden en çok saptığı yer, ve yinelemeyle çözülen her grubun
denklemlerinin en zayıf olduğu yer. Var olmayan bir büyüklüğün nedeni yazılır.";
        examples_of_study = "\
Örnekler:
  krank study four-bar --vary r2.length=90..110/21 --columns r4.angle.swing
  krank study four-bar --vary r2.length=90..110/21,r3.length=280..320/9 \\
    --columns r4.angle.swing,transmission -o designs.csv
  krank study four-bar --vary r2.length=60..140,r3.length=200..320 \\
    --columns r4.angle.swing --format chart
  krank study press --vary r2.length=80..120,r3.length=250..330 --latin 1000 \\
    --seed 7 --columns r6.angle.swing --format text

Değerlerin adı krank check ve tezgâhtaki gibidir, boşluk yerine nokta:
r3.length, A.x, driver.angle; parametreler kendi adlarıyla. En hızlı son değer
değişir. Her tasarım, bu değerlerle sahnenin montaj biçiminde açılan sahnedir. Son
sütunlar durumu (ok, no-assembly ya da değerler geçerli bir sahne vermiyorsa
unreadable) ve eksik değerlerin nedenidir. CSV dosyası satır satır yazılır: Ctrl-C
ile kesilirse --resume sürdürür. Ayrıntılar: krank help designs.";
        examples_of_motor = "\
Örnekler:
  krank motor four-bar-load
  krank motor four-bar-load --rated 30 --peak 75 --fluctuation 0.02
  krank motor press-ram --height 6 --torque 500 --rest 0.5
  krank motor excavator-boom --from 1.8 --to 2.8
  krank motor engine --format csv -o engine.csv

Tork ve güç, çözülen tepe değerleri, ortalamaları, verilen ve geri alınan enerji;
yüklere, yerçekimine ve atalete ayrılmış olarak; hızın ne kadar dalgalandığı ve buna
karşı volan; şaseyi sarsan kuvvet; motorun eksiği; koç için strok, ölü noktalar, zaman
oranı, bekleme, alt noktanın üstündeki bir yükseklikte hız ve kuvvet. Döngü, hareketin
periyodudur, daha uzunsa yüklerinki; sınırlı aralık gidilip dönülür. Seçenekler
sahnenin [motor] bölümünün yerine geçer. Sürtünme modellenmez.";
        examples_of_tolerance = "\
Örnekler:
  krank tolerance four-bar --tolerance 0.1 --columns C.x,r4.angle --at 60
  krank tolerance press.toml --columns F.y
  krank tolerance press.toml --columns F.y --samples 10000 --format csv -o off.csv

Her büyüklük için: verildiği gibi değeri; bütün toleranslar içinde en kötü durum;
her boyun tek başına yaptığının karelerinin toplamının karekökü; tek bir konumda
ayrıca rastgele örneklerin değerleri ve her boyun payı verilir. En kötü
durum, 16 boya (bir strokta 12 boya) kadar toleransların her köşesinde çözülür. Daha
çok boyda ve boşluklu pimlerde kuşatılır; bunlar olmazsa tahmin olduğu ve yöntemi
yazılır. Toleranslar sahneden alınır: tolerance, clearance, [tolerances],
[clearances].";
        examples_of_start = "\
Örnekler:
  krank start four-bar --assembly C=- > crossed.toml
  krank start my-press.toml --assembly C=-,F=+ -o my-press.toml

Yalnız [start] değişir: açıklamalar, sıra ve gerisi olduğu gibi kalır. Dosya ya bir
kerede yazılır ya hiç yazılmaz; sahnenin kendisi de olabilir. Montaj biçiminin
hareketi sahnenin açıldığı konuma ulaşmıyorsa bu konum da değişir.";
        examples_of_accuracy = "\
Örnekler:
  krank accuracy                 derslerdeki dört çubuk
  krank accuracy jansen-leg -o jansen.csv
  krank accuracy my-press.toml --positions 36000

Her yöntem konum, hız ve ivme verir ve double-double bir hesapla
karşılaştırılır. Sahnede kullanılamayan yöntemler nedeniyle listelenir. Süreler bu
makinede ölçülür: o sırada başka iş çalıştırmayın. Ctrl-C bitirir.";
        examples_of_config = "\
Örnek:
  krank config > ~/.config/krank/config.toml

Tezgâh $XDG_CONFIG_HOME/krank/config.toml dosyasını, bu değişken yoksa
~/.config/krank/config.toml dosyasını okur, hiç yazmaz: karakterler, renkler, dil,
tuşlar.";
        examples_of_help = "\
Örnekler:
  krank help                     konular
  krank help scene               sahne dosyasının her anahtarı; krank help sahne de olur
  krank help sweep               krank sweep --help gibi
  krank help 'zaman oranı'       bu sözcüklerin geçtiği konular, tuşlar, sütunlar, komutlar
  krank help --format html -o manual   el kitabı, web sitesi olarak

Terminalde $PAGER ile, yoksa less ya da more ile gösterilir.";
        examples_of_completions = "\
Örnek:
  krank completions bash > ~/.local/share/bash-completion/completions/krank";
        examples_of_man = "\
Örnekler:
  krank man > krank.1
  krank man sweep > krank-sweep.1";
    }
}
