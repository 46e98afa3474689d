# Prints the commands of OpenSees that a script gives, for the small solver: one a line, words between characters 31.
# A second route beside hinge's own recorder: everything that Tcl does not know is a command.
# Its value grows from call to call, so that loops up to a displacement end; that of analyze is 0.
#
# Run: tclsh record.tcl FILE
set path [file normalize [lindex $argv 0]]
cd [file dirname $path]
set s [interp create -safe]
set calls 0
proc record args {
  puts [string map {\n " "} [join $args \x1f]]
  if {[lindex $args 0] eq "eigen"} { return [lrepeat [lindex $args end] 1.0] }
  return [expr {[lindex $args 0] eq "analyze" ? 0 : [incr ::calls]}]
}
proc ignore args {}
proc from_file args { global s; interp invokehidden $s source [lindex $args end] }
foreach name {puts file open close exec gets fconfigure cd} { interp alias $s $name {} ignore }
interp alias $s source {} from_file
interp alias $s unknown {} record
# the loads or fibres in braces are commands
foreach name {pattern section} {
  interp alias $s record_$name {} record $name
  interp eval $s [string map [list NAME $name] {
    proc NAME args {
      if {[lindex $args 0] in {Plain Fiber fiberSec} && [llength $args] > 2 + ([lindex $args 0] eq "Plain")
          && ![regexp {^[-+.\d]*$|^[A-Za-z]+$} [lindex $args end]] || [lindex $args end] eq ""} {
        record_NAME {*}[lrange $args 0 end-1]
        uplevel 1 [lindex $args end]
      } else {
        record_NAME {*}$args
      }
    }
  }]
}
interp limit $s time -seconds [expr {[clock seconds] + 20}]
interp invokehidden $s source $path
