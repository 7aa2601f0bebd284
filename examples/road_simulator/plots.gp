# SPDX-License-Identifier: MIT
# Plots of the road-simulator study; run it in the folder of the CSV files: gnuplot plots.gp
set datafile separator ","
set key autotitle columnhead noenhanced
set style line 1 lc rgb "#1f4e79" lw 1.8
set style line 2 lc rgb "#c55a11" lw 1.8
set style line 3 lc rgb "#7f7f7f" lw 1.6 dt 2
set grid xtics ytics lt 1 lc rgb "#d0d0d0" lw 0.8
set tics nomirror out
set border 3
set ylabel offset 1,0

# Spectra of the three dampers, as the thesis's figures 33 to 43.
names = "standard harder undamped"
array shown[4]
do for [model in "half_truck truck_3d"] {
    shown[1] = "front axle"; shown[2] = "rear axle"
    shown[3] = "frame at front cab mount"; shown[4] = "cab at front mount"
    set terminal pngcairo size 1200,900 font "DejaVu Sans,11"
    set output sprintf("psd_%s.png", model)
    set multiplot layout 2,2 title sprintf("Acceleration PSD on the road simulator, %s, left side\n{/*0.8 sweep 0.8 to 20 Hz, 480 s; normalised by the standard damper's maximum}", model eq "half_truck" ? "half truck" : "3D truck")
    set xrange [0:22]
    set logscale y
    set format y "10^{%T}"
    set yrange [1e-4:*]
    set xlabel "frequency [Hz]"
    set ylabel "PSD / maximum [-]"
    do for [k=1:4] {
        set title shown[k]
        plot for [c=1:3] sprintf("psd_%s.csv", model) using 1:(column(1+3*(k-1)+c)) \
            with lines ls c title word(names, c)
    }
    unset multiplot
}

set output "psd_quarter.png"
set terminal pngcairo size 1200,450 font "DejaVu Sans,11"
set multiplot layout 1,2 title "Acceleration PSD on the road simulator, front quarter car"
set title "unsprung mass"
plot for [c=1:3] "psd_quarter_front.csv" using 1:(column(1+c)) with lines ls c title word(names, c)
set title "sprung mass"
plot for [c=1:3] "psd_quarter_front.csv" using 1:(column(4+c)) with lines ls c title word(names, c)
unset multiplot
unset logscale y
set format y

# Time signals of the standard truck, as figures 18 and 19.
set terminal pngcairo size 1200,900 font "DejaVu Sans,11"
set output "time_truck_3d.png"
set multiplot layout 2,2 title "Acceleration on the road simulator, 3D truck, standard dampers, left side"
set xrange [0:480]
set yrange [*:*]
set xlabel "time [s]"
set ylabel "acceleration [m/s^2]"
unset key
signals = "cab_front_left_z frame_front_left_z front_axle_left_z rear_axle_left_z"
titles = "cab_at_front_mount frame_at_front_cab_mount front_axle rear_axle"
do for [k=1:4] {
    set title system(sprintf("echo %s | tr _ ' '", word(titles, k)))
    plot "time_truck_3d_standard.csv" using 1:sprintf("%s [m/s^2]", word(signals, k)) with lines lc rgb "#1f4e79" lw 0.6
}
unset multiplot

# Step and sine against the independent integrator, as figures 7 to 12.
set output "verification.png"
set multiplot layout 3,2 title "Newmark at 1 ms against Runge-Kutta at 0.05 ms: step 0.01 m, sine 0.01 m at 1 Hz"
set xrange [0:8]
do for [row in "thesis_quarter:sprung.z half_truck:cab.z truck_3d:frame.z"] {
    model = row[1:strstrt(row, ":")-1]
    coordinate = row[strstrt(row, ":")+1:*]
    set title sprintf("%s, %s", model, coordinate) noenhanced
    set ylabel "displacement [mm]"
    set key top right horizontal samplen 2
    set offsets 0, 0, graph 0.3, 0
    plot for [c=1:2] sprintf("verify_%s_%s.csv", model, word("step sine", c)) \
             using 1:(1e3*column(coordinate." newmark")) with lines lc rgb word("#9dc3e6 #f4b183", c) lw 5 \
             title word("step sine", c).", Newmark", \
         for [c=1:2] sprintf("verify_%s_%s.csv", model, word("step sine", c)) \
             using 1:(1e3*column(coordinate." reference")) with lines lc rgb "black" lw 1 dt 2 \
             title c == 1 ? "Runge-Kutta" : ""
    set ylabel "difference [micrometre]"
    plot for [c=1:2] sprintf("verify_%s_%s.csv", model, word("step sine", c)) \
             using 1:(1e6*(column(coordinate." newmark")-column(coordinate." reference"))) \
             with lines lc rgb word("#1f4e79 #c55a11", c) title word("step sine", c)
}
unset multiplot
