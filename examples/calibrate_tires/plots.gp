# SPDX-License-Identifier: MIT
# Plots of the tire calibration; run it in the folder of the CSV files: gnuplot plots.gp
set datafile separator ","
set datafile columnheaders
set grid xtics ytics lt 1 lc rgb "#d0d0d0" lw 0.8
set tics nomirror out
set border 3
set style line 1 lc rgb "#7f7f7f" lw 2
set style line 2 lc rgb "#1f4e79" lw 1.8 pt 7 ps 1.3
set style line 3 lc rgb "#c55a11" lw 1.8 pt 5 ps 1.2
set style line 4 lc rgb "#548235" lw 1.8 dt (6,4) pt 9 ps 1.5
array set_title[4]
set_title[1] = "original tires"
set_title[2] = "by undamped frequency"
set_title[3] = "by damped frequency"
set_title[4] = "by PSD peak"
variants = "linear thesis_dampers nonlinear"
array variant_title[3]
variant_title[1] = "linear"; variant_title[2] = "dampers of the thesis"; variant_title[3] = "non-linear"

# One legend below all panels of a page, and back.
legend = "unset logscale; unset border; unset tics; unset title; unset xlabel; unset ylabel; unset arrow; unset label; \
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.01; set tmargin at screen 0.07; \
set xrange [0:1]; set yrange [0:1]; set key center center horizontal samplen 3 width 1"
panels = "set lmargin; set rmargin; set bmargin; set tmargin; set border 3; set tics nomirror out; set xtics auto nomirror out; set ytics auto nomirror out; set format y"

# Spectra of the axles: front above, rear below, the measured frequency dashed.
array file_name[6]; array first[6]; array title_text[6]
file_name[1] = "quarter_front"; file_name[2] = "half_truck"; file_name[3] = "truck_3d"
file_name[4] = "quarter_rear";  file_name[5] = "half_truck"; file_name[6] = "truck_3d"
first[1] = 2; first[2] = 2; first[3] = 2; first[4] = 2; first[5] = 6; first[6] = 6
title_text[1] = "front quarter car"; title_text[2] = "half truck, front axle"
title_text[3] = "3D truck, front axle"; title_text[4] = "rear quarter car"
title_text[5] = "half truck, rear axle"; title_text[6] = "3D truck, rear axle"
do for [v=1:3] {
    set terminal pngcairo size 1350,860 font "DejaVu Sans,11"
    set output sprintf("psd_%s.png", word(variants, v))
    set multiplot layout 2,3 margins 0.065,0.985,0.14,0.90 spacing 0.055,0.13 \
        title sprintf("Axle acceleration on the road simulator before and after trimming the tires: %s", variant_title[v])
    set logscale y
    set format y "10^{%T}"
    set xrange [0:20]
    set yrange [1e-5:1]
    set xlabel "frequency [Hz]"
    do for [k=1:6] {
        target = k <= 3 ? 13.8 : 10
        set title title_text[k]
        set ylabel (k % 3 == 1 ? "PSD [(m/s^2)^2/Hz]" : "")
        unset arrow
        unset label
        set arrow from target, graph 0 to target, graph 1 nohead dt 2 lc rgb "black" lw 1.2
        set label sprintf("measured %.1f Hz", target) at target-0.3, graph 0.03 right font ",9"
        unset key
        plot for [s=1:4] sprintf("psd_%s_%s.csv", file_name[k], word(variants, v)) \
                 using 1:(column(first[k]+s-1)) with lines ls s
    }
    @legend
    plot for [s=1:4] NaN with lines ls s title set_title[s]
    unset multiplot
    @panels
}

# Frequencies before, and the factors, by model and variant.
unset arrow
unset label
place(model, variant) = (model[1:7] eq "quarter" ? 0 : model eq "half_truck" ? 4 : 8) \
                      + (variant eq "linear" ? 0 : variant eq "thesis_dampers" ? 1 : 2)
methods = "undamped damped psd_peak"
shown(a, m, value) = strcol("axle") eq a && strcol("method") eq m ? value : NaN
set output "overview.png"
set terminal pngcairo size 1350,860 font "DejaVu Sans,11"
unset key
set multiplot layout 2,2 margins 0.06,0.985,0.16,0.90 spacing 0.07,0.16 \
    title "Tires of the reference tractor trimmed to the measured axle frequencies"
set xrange [-0.7:10.7]
set xtics ("lin." 0, "thesis\nquarter car" 1, "non-lin." 2, "lin." 4, "thesis\nhalf truck" 5, \
           "non-lin." 6, "lin." 8, "thesis\n3D truck" 9, "non-lin." 10) scale 0 font ",9.5"
unset xlabel
unset grid
set grid ytics lt 1 lc rgb "#d0d0d0" lw 0.8
do for [axle in "front rear"] {
    target = axle eq "front" ? 13.8 : 10
    set title sprintf("%s axle: frequency before (open) and after (filled)", axle)
    set ylabel "frequency [Hz]"
    set yrange [0:16]
    plot target with lines dt 2 lc rgb "black", \
         for [m=1:3] "factors.csv" using (place(strcol("model"), strcol("variant"))+0.22*(m-2)): \
             (shown(axle, word(methods, m), column("before_hz"))) with points ls m+1 \
             pt (m == 1 ? 6 : m == 2 ? 4 : 8), \
         for [m=1:3] "factors.csv" using (place(strcol("model"), strcol("variant"))+0.22*(m-2)): \
             (shown(axle, word(methods, m), column("after_hz"))) with points ls m+1
}
do for [axle in "front rear"] {
    set title sprintf("%s axle: factor on the tire stiffness, 95 %% interval", axle)
    set ylabel "factor [-]"
    set yrange [0:12]
    plot "factors.csv" using (place(strcol("model"), strcol("variant"))-0.4): \
             (shown(axle, "undamped", column("thesis_factor"))):(0.8):(0) \
             with vectors nohead lc rgb "#7f7f7f" lw 4, \
         for [m=1:3] "factors.csv" using (place(strcol("model"), strcol("variant"))+0.22*(m-2)): \
             (shown(axle, word(methods, m), column("factor"))):(column("low95")):(column("high95")) \
             with yerrorbars ls m+1
}
@legend
plot NaN with lines dt 2 lc rgb "black" title "measured", \
     for [m=1:3] NaN with points ls m+1 title (m == 1 ? "by undamped frequency" : m == 2 ? "by damped frequency" : "by PSD peak"), \
     NaN with lines lc rgb "#7f7f7f" lw 4 title "factor of the thesis"
unset multiplot
