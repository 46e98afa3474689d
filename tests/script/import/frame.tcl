# Two bays by one bay, two storeys. Units: kN, m, s.
wipe
model BasicBuilder -ndm 3 -ndf 6

set E 210.0e6
set G [expr $E/2.6]
set rho 7.85; # t/m3
set bay 6.0
set depth 5
set height 3.5

# nodes: 1 + i + 3 j + 6 k
for {set k 0} {$k < 3} {incr k} {
  for {set j 0} {$j < 2} {incr j} {
    foreach i {0 1 2} {
      node [expr 1 + $i + 3*$j + 6*$k] [expr $i*$bay] [expr {$j * $depth}] \
        [expr $k*$height]
    }
  }
}
foreach n {1 2 4 5 6} { fix $n 1 1 1 1 1 1 }
fix 3 1 1 1 0 0 1

geomTransf Linear 1 1 0 0
geomTransf Linear 2 0 0 1
set pi [expr {acos(-1.0)}]
geomTransf Linear 3 [expr cos($pi/6)] [expr sin($pi/6)] 0.0

# columns: E G A J Iy Iz Avy Avz
set tag 0
set column(A) 0.0149
for {set first 1} {$first <= 12} {incr first} {
  incr tag
  if {$tag == 8} { set t 3 } else { set t 1 }
  element ElasticTimoshenkoBeam $tag $first [expr $first + 6] $E $G $column(A) 1.85e-6 2.517e-4 8.563e-5 \
    0.0095 0.0035 $t -mass [expr $rho*$column(A)]
}

# beams: one section, as numbers and by its tag
set A 0.00845
section Elastic 7 $E $A 1.318e-5 2.313e-4 $G 5.1e-7
foreach level {1 2} {
  foreach j {0 1} {
    for {set i 0} {$i < 2} {incr i} {
      incr tag
      set a [expr 1 + $i + 3*$j + 6*$level]
      element elasticBeamColumn $tag $a [expr $a + 1] $A $E $G 5.1e-7 2.313e-4 1.318e-5 2 -mass [expr $rho*$A]
      lappend loaded $tag
    }
  }
  for {set i 0} {$i < 3} {incr i} {
    incr tag
    set a [expr 1 + $i + 6*$level]
    element forceBeamColumn $tag $a [expr $a + 3] 5 7 2 -mass [expr $rho*$A]
  }
}

timeSeries Linear 1
pattern Plain 1 1 {
  foreach e $loaded {
    eleLoad -ele $e -type -beamUniform 0 -12.0
  }
}
pattern Plain 2 Linear {
  load  7 20 0 0 0 0 0
  load 13 35 0 0 0 0 4; load 18 12 5 0 0 0 0
  eleLoad -ele 2 -type -beamUniform -1 -3
}

constraints Plain
system BandGeneral
numberer RCM
analysis Static
analyze 1
puts "sway [nodeDisp 13 1]"
