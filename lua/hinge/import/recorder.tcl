# Runs a script of OpenSees in a safe interpreter and writes down the commands that it gives, for recorded.lua.
#
#   tclsh recorder.tcl FILE TURN SECONDS COMMANDS RESULTS QUIET KNOWN
#
# FILE     the script, symbolic links resolved; it and what it sources and reads lie in its folder or below
# TURN     1 or 2: results of the analysis are made up, and differ between the turns. Where the two records differ, a
#          number hangs on such a result.
# SECONDS, COMMANDS   limits of time, and of the number of commands of Tcl
# RESULTS  names of commands whose value is a result; QUIET, of others that compute or print; KNOWN, of the rest
#
# Output: records of fields, which end with the characters 31 and 30. The first field is the kind:
#   c file line text name argument ...   a command         e   the end of the braces of a pattern or section
#   s file line text                     a command that computes or prints, and is not run
#   x file line message                  an error ends the script    l file line message   a limit ends it
#   .                                    the script has come to its end
# A file is named as seen from the folder; "" is the script itself.
lassign $argv main turn seconds most_commands results quiet known
set folder [file dirname $main]
set kinds [dict create]
foreach name $results { dict set kinds $name result }
foreach name $quiet { dict set kinds $name quiet }
foreach name $known { dict set kinds $name known }
cd $folder
fconfigure stdout -encoding utf-8 -translation lf
set own [file normalize [info script]]
set s [interp create -safe]

# Records -------------------------------------------------------------------------------------------------------------

proc put {args} {
  set fields {}
  foreach field $args { lappend fields [string map {\x1e " " \x1f " "} $field] }
  puts -nonewline "[join $fields \x1f]\x1f\x1e"
  flush stdout
}

proc relative path {
  global folder main
  if {$path eq $main} { return "" }
  set inner [string trimright $folder /]/
  if {[string first $inner $path] == 0} { return [string range $path [string length $inner] end] }
  return $path
}

# Where the command stands that runs now: file, line, text. A command in the braces of a pattern inside a procedure has
# a line within the braces; one that was put together as text (eval) has that of the command that runs it.
proc where {} {
  global s own main
  set inner 0
  for {set i -1} {![catch {interp eval $s [list info frame $i]} frame]} {incr i -1} {
    set line [expr {[dict exists $frame line] ? [dict get $frame line] : 0}]
    set file [expr {[dict exists $frame file] ? [dict get $frame file] : ""}]
    set cmd [expr {[dict exists $frame cmd] ? [dict get $frame cmd] : ""}]
    if {$file eq $own} continue
    if {$file eq ""} {
      if {$i == -1 && [dict exists $frame proc] && [dict get $frame proc] in {::pattern ::section}} { set inner $line }
      if {![info exists text]} { set text $cmd }
      continue
    }
    if {$inner} {
      set block [string last "\{" [string range $cmd 0 [string first "\n" $cmd]]]
      incr line [expr {$inner - 1 + [regexp -all {\n} [string range $cmd 0 [expr {max($block, 0)}]]]}]
    }
    if {![info exists text]} { set text $cmd }
    return [list [relative $file] $line [string range $text 0 300]]
  }
  return [list [relative $main] 1 [expr {[info exists text] ? $text : ""}]]
}

proc skip {} { put s {*}[where] }

# Ends the script, from within, with a last record.
proc finish {args} {
  put {*}$args
  exit 0
}

# What a script may ask for -------------------------------------------------------------------------------------------

set steps 0
set now 0.0
set per_step 1.0
array set nodes {}
array set elements {}
set node_order {}
set element_order {}

# A result that is not known. It grows with the analyses, so that loops up to a displacement end; it is small in one
# turn and large in the other, so that what a script does beyond a limit differs.
proc made_up {{n 1}} {
  global turn steps
  set grown [expr {min($steps, 100)}]
  return [expr {($turn == 1 ? 1.0e-3 * 1.31**$grown : 1.7e4 * 1.47**$grown) * (1 + 0.1*$n)}]
}

proc made_up_list count {
  for {set i 1} {$i <= $count} {incr i} { lappend list [made_up $i] }
  return $list
}

proc computed {name arguments} {
  global steps now per_step nodes elements node_order element_order
  set first [lindex $arguments 0]
  switch -- $name {
    analyze {
      set count [expr {[string is integer -strict $first] ? $first : 1}]
      set dt [lindex $arguments 1]
      incr steps $count
      set now [expr {$now + $count * ([string is double -strict $dt] ? $dt : $per_step)}]
      return 0
    }
    eigen {
      set count [lindex $arguments end]
      if {![string is integer -strict $count] || $count < 1 || $count > 10000} { set count 1 }
      for {set i 1} {$i <= $count} {incr i} { lappend list [expr {[made_up] * 1e5 * $i * $i}] }
      return $list
    }
    getTime { return $now }
    getNodeTags { return $node_order }
    getEleTags { return $element_order }
    nodeCoord {
      if {![info exists nodes($first)]} { error "node $first is not there" }
      if {[llength $arguments] < 2} { return $nodes($first) }
      set axis [string map {X 1 Y 2 Z 3} [string toupper [lindex $arguments 1]]]
      return [lindex $nodes($first) [expr {$axis - 1}]]
    }
    eleNodes {
      if {![info exists elements($first)]} { error "element $first is not there" }
      return $elements($first)
    }
    testIter - numIter { global turn; return $turn }
    getPID { return 0 }
    getNP { return 1 }
    testNorm - testNorms { return 0.0 }
  }
  if {[string match ele* $name] || [string match basic* $name] || [string match section* $name]} {
    return [made_up_list 12]
  }
  if {[llength $arguments] > 1 || ![string match node* $name]} { return [made_up] }
  return [made_up_list 6]
}

# Keeps what nodeCoord and the like tell.
proc keep {name arguments} {
  global nodes elements node_order element_order now per_step steps
  switch -- $name {
    node {
      set at {}
      foreach x [lrange $arguments 1 end] {
        if {![string is double -strict $x]} break
        lappend at $x
      }
      set nodes([lindex $arguments 0]) $at
      lappend node_order [lindex $arguments 0]
    }
    element {
      lassign $arguments kind tag i j
      set elements($tag) [list $i $j]
      lappend element_order $tag
    }
    remove {
      set tag [lindex $arguments 1]
      if {[lindex $arguments 0] eq "node"} { set node_order [lsearch -all -inline -not -exact $node_order $tag] }
      if {[lindex $arguments 0] eq "element"} {
        set element_order [lsearch -all -inline -not -exact $element_order $tag]
      }
    }
    wipe {
      array unset nodes
      array unset elements
      lassign {{} {} 0.0 0} node_order element_order now steps
    }
    integrator {
      set by [lindex $arguments 1]
      set per_step [expr {[lindex $arguments 0] eq "LoadControl" && [string is double -strict $by] ? $by : [made_up]}]
    }
    setTime - loadConst {
      set at [lsearch -exact $arguments -time]
      set by [lindex $arguments [expr {$name eq "setTime" ? 0 : $at + 1}]]
      if {($name eq "setTime" || $at >= 0) && [string is double -strict $by]} { set now [expr {double($by)}] }
    }
  }
}

# How many letters two words differ by: changed, left out, put in, or two exchanged.
proc distance {a b} {
  set row {}
  for {set j 0} {$j <= [string length $b]} {incr j} { lappend row $j }
  set before {}
  for {set i 1} {$i <= [string length $a]} {incr i} {
    set next [list $i]
    for {set j 1} {$j <= [string length $b]} {incr j} {
      set c [expr {[string index $a $i-1] ne [string index $b $j-1]}]
      set d [expr {min([lindex $row $j] + 1, [lindex $next end] + 1, [lindex $row $j-1] + $c)}]
      if {$i > 1 && $j > 1 && [string index $a $i-1] eq [string index $b $j-2]
        && [string index $a $i-2] eq [string index $b $j-1]} { set d [expr {min($d, [lindex $before $j-2] + 1)}] }
      lappend next $d
    }
    set before $row
    set row $next
  }
  return [lindex $row end]
}

# The command of OpenSees or of Tcl that a name was probably meant to be, or "".
proc meant name {
  global kinds s
  if {[string length $name] < 3} { return "" }
  # node2 and fix3 are names that somebody gave
  if {[regexp {^(.*[^\d_])[\d_]+$} $name -> stem] && ([dict exists $kinds $stem]
    || [interp eval $s [list info commands $stem]] ne "")} { return "" }
  foreach other [concat [dict keys $kinds] [interp eval $s {info commands}]] {
    set apart [expr {abs([string length $name] - [string length $other])}]
    if {$apart <= 1 && [string length $other] > 3 && [distance $name $other] == 1} { return $other }
  }
  return ""
}

# A command that Tcl does not know: one of OpenSees, or a mistake.
proc command {name args} {
  global kinds
  if {[string match ::* $name]} { set name [string range $name 2 end] }
  if {![dict exists $kinds $name]} {
    set other [meant $name]
    if {$other ne ""} { error "invalid command name \"$name\" (did you mean '$other'?)" }
    if {![regexp {^[A-Za-z]\w*$} $name]} { error "invalid command name \"$name\"" }
    dict set kinds $name other
  }
  put c {*}[where] $name {*}$args
  keep $name $args
  if {[dict get $kinds $name] in {result other}} { return [computed $name $args] }
  return ""
}

# pattern and section, whose last word may be commands in braces: records it, and tells whether the braces follow.
proc block {name arguments} {
  set last [string trim [lindex $arguments end]]
  set before [lindex $arguments end-1]
  set least [expr {$name eq "pattern" && [lindex $arguments 0] eq "Plain" ? 4 : 3}]
  set braces [expr {[llength $arguments] >= $least && ![string match -\[a-z\]* $before]
    && ($last eq "" || [regexp {^[A-Za-z#\$]\S*\s} $last])}]
  put c {*}[where] $name {*}[expr {$braces ? [lrange $arguments 0 end-1] : $arguments}]
  return $braces
}

# Files ---------------------------------------------------------------------------------------------------------------

# The path of a file below the folder, symbolic links resolved; an error for others.
proc below {what name} {
  global folder
  set path [file normalize [file join [pwd] $name]]
  # normalize leaves a link in the last part as it is
  for {set i 0} {$i < 40 && ![catch {file readlink $path} to]} {incr i} {
    set path [file normalize [file join [file dirname $path] $to]]
  }
  if {$path ne $folder && [string first [string trimright $folder /]/ $path] != 0} {
    error "$what $name: only files in the folder of the script, or below it, are read"
  }
  return $path
}

proc source_file args {
  global s main
  set name [lindex $args end]
  set path [below source $name]
  if {![file exists $path]} {
    set beside [below source [file join [file dirname [interp eval $s {info script}]] $name]]
    if {[file exists $beside]} { set path $beside }
  }
  if {![file exists $path]} { error "couldn't read file \"$name\": no such file or directory" }
  if {[file type $path] ne "file"} { error "source $name: it is no file" }
  if {[file size $path] > 500000000} { error "source $name: more than 500 MB are not read" }
  uplevel 1 [list interp invokehidden $s source $path]
}

set fakes 0
# A file to be written is none; what goes there is dropped. Files below the folder may be read.
proc open_file {name {mode r} args} {
  global s fakes
  if {$mode ni {r rb RDONLY}} {
    skip
    return "unwritten[incr fakes]"
  }
  if {[string match |* $name]} { error "open: a program is not started" }
  set path [below open $name]
  if {![file exists $path]} { error "couldn't open \"$name\": no such file or directory" }
  if {[file type $path] ne "file"} { error "open $name: it is no file" }
  set channel [open $path r]
  interp transfer {} $channel $s
  return $channel
}

proc on_channel {name channel args} {
  global s
  if {![string match unwritten* $channel]} { return [interp invokehidden $s $name $channel {*}$args] }
  return [dict get {close "" eof 1 gets -1 read "" seek "" tell 0} $name]
}

proc about_files {what args} {
  switch -- $what {
    mkdir - delete - copy - rename { skip; return "" }
    join - dirname - tail - extension - rootname - split - pathtype - nativename - normalize { return [file $what {*}$args] }
    exists - isfile - isdirectory - readable - size {
      if {[catch {below file [lindex $args 0]} path]} { return 0 }
      return [file $what $path]
    }
  }
  error "file $what is not available to a script that hinge reads"
}

proc change_folder {{name .}} { cd [below cd $name] }

proc refused {name args} { error "$name is not available to a script that hinge reads" }

proc run_program {args} {
  if {[lindex $args 0] eq "mkdir"} { return [skip] }
  refused exec
}

proc time_of {what args} {
  if {$what in {seconds milliseconds microseconds clicks}} { return [clock $what] }
  if {$what in {format scan}} { return [clock $what [lindex $args 0]] }
  error "clock $what is not available to a script that hinge reads"
}

proc packages {what args} { return [expr {$what in {require present provide} ? "1.0" : ""}] }

# The interpreter -----------------------------------------------------------------------------------------------------

foreach name {close eof gets read seek tell} {
  interp hide $s $name
  interp alias $s $name {} on_channel $name
}
foreach {name does} {puts skip_any flush nothing fconfigure nothing after nothing vwait nothing update nothing
  encoding nothing source source_file open open_file file about_files cd change_folder pwd pwd exec run_program
  clock time_of package packages unknown command exit ended hinge_block block hinge_end block_ended} {
  interp alias $s $name {} $does
}
foreach name {glob socket interp fileevent fcopy chan unload} { interp alias $s $name {} refused $name }
proc nothing args {}
proc skip_any args { skip }
proc ended args { finish . }
proc block_ended {} { put e }
foreach name {pattern section} {
  interp eval $s [string map [list NAME $name] {
    proc NAME args {
      if {[::hinge_block NAME $args]} {
        uplevel 1 [lindex $args end]
        ::hinge_end
      }
    }
  }]
}
interp eval $s { proc pset {name value} { uplevel 1 [list set $name $value] } }
interp eval $s [list set argv0 [file tail $main]]
interp eval $s {set argv {}; set argc 0; set tcl_interactive 0}
interp recursionlimit $s 500

interp limit $s command -value $most_commands
interp limit $s time -seconds [expr {[clock seconds] + int($seconds)}] \
  -milliseconds [expr {int(1000 * ($seconds - int($seconds)))}]

if {[catch {interp invokehidden $s source $main} message]} {
  interp limit $s command -value {}
  interp limit $s time -seconds {}
  # the innermost file of the trace is that of the error, and the line that of its outermost command
  set file $main
  set line 1
  set trace [interp eval $s {set ::errorInfo}]
  interp delete $s ;# it may hold all memory
  regexp {\(file "([^\n]*)" line (\d+)\)} $trace -> file line
  set kind x
  if {$message eq "command count limit exceeded"} {
    lassign [list l "the script runs more than $most_commands commands"] kind message
  } elseif {$message eq "time limit exceeded"} {
    lassign [list l "the script takes more than $seconds s; does a loop in it have no end?"] kind message
  }
  put $kind [relative $file] $line $message
} else {
  put .
}
