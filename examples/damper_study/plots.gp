# SPDX-License-Identifier: MIT
# One page of the damper study; run it in the folder of the CSV files: gnuplot plots.gp
set datafile separator ","
set datafile columnheaders
set terminal pngcairo size 1350,1150 font "DejaVu Sans,11"
set output "damper_study.png"
set grid xtics ytics lt 1 lc rgb "#d0d0d0" lw 0.8
set tics nomirror out
set border 3
set style line 1 lc rgb "#1f4e79" lw 1.8
set style line 2 lc rgb "#c55a11" lw 1.8
set style line 3 lc rgb "#7f7f7f" lw 1.8 dt (8,4)
configurations = "standard harder undamped"
array files[9]; array first[9]; array titles[9]
files[1] = "quarter_front"; first[1] = 2;  titles[1] = "front quarter car: unsprung mass"
files[2] = "quarter_front"; first[2] = 5;  titles[2] = "front quarter car: sprung mass"
files[4] = "half_truck";    first[4] = 2;  titles[4] = "half truck: front axle"
files[5] = "half_truck";    first[5] = 8;  titles[5] = "half truck: frame at front cab mount"
files[6] = "half_truck";    first[6] = 11; titles[6] = "half truck: cab at front mount"
files[7] = "truck_3d";      first[7] = 2;  titles[7] = "3D truck: front axle, left"
files[8] = "truck_3d";      first[8] = 8;  titles[8] = "3D truck: frame at front cab mount, left"
files[9] = "truck_3d";      first[9] = 11; titles[9] = "3D truck: cab at front mount, left"
unset key
set multiplot layout 3,3 margins 0.06,0.985,0.095,0.925 spacing 0.065,0.095 \
    title "Front-axle damper on the road simulator: sweep 0.8 to 20 Hz in 480 s, 1 mm at 1 Hz, tires trimmed to 13.8 and 10 Hz"
do for [k=1:9] {
    unset arrow
    if (k == 3) {
        unset logscale y
        set format y "%g"
        set title "damper of the front axle, extension positive"
        set xrange [-0.5:0.5]
        set yrange [-8:2]
        set xlabel "velocity [m/s]"
        set ylabel "force [kN]" offset 1,0
        plot for [c=1:3] "damper_curves.csv" using 1:(column(1+c)/1000) with lines ls c
    } else {
        set logscale y
        set format y "10^{%T}"
        set title titles[k]
        set xrange [0:22]
        set yrange [k % 3 == 0 ? 1e-9 : 1e-6 : k % 3 == 0 ? 1 : 100]
        set xlabel (k >= 7 || k == 3 ? "frequency [Hz]" : "")
        set ylabel (k % 3 == 1 ? "PSD [(m/s^2)^2/Hz]" : "") offset 1,0
        if (k % 3 == 1) { set arrow from 13.8, graph 0 to 13.8, graph 1 nohead dt 3 lc rgb "black" }
        plot for [c=1:3] sprintf("damper_psd_%s.csv", files[k]) using 1:(column(first[k]+c-1)) \
             with lines ls c
    }
}
# One legend below all panels.
unset logscale; unset border; unset tics; unset title; unset xlabel; unset ylabel; unset arrow
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.005; set tmargin at screen 0.04
set xrange [0:1]
set yrange [0:1]
set key center center horizontal samplen 4 width 1
plot for [c=1:3] NaN with lines ls c title word(configurations, c)." front damper"
unset multiplot
