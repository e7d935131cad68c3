<?xml version="1.0" standalone="no"?>
<!DOCTYPE DDA SYSTEM "geometry.dtd">
<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">
<!-- geometry -->
<Berkeley:Geometry>
<Berkeley:Edgenodedist distance="0.01"/>
<Jointlist>
<Joint type="1"> -1.005 -1.740711062 0.005 0.008660254038 </Joint>
<Joint type="1"> -1.008660254 -1.727050808 16.32916833 -11.73705081 </Joint>
<Joint type="1"> 16.31550808 -11.74071106 17.32550808 -9.991339746 </Joint>
<Joint type="1"> -0.008660254038 0.005 17.32916833 -10.005 </Joint>
<Joint type="1"> 5.191152423 -3.008660254 5.988448244 -1.627703382 </Joint>
<Joint type="1"> 6.057177826 -3.508660254 6.854473648 -2.127703382 </Joint>
<Joint type="1"> 5.97478799 -1.631363636 6.858133902 -2.141363636 </Joint>
</Jointlist>
<Fixedpointlist>
<Point> 0.1160254038 -1.799038106 </Point>
<Point> 15.70448267 -10.79903811 </Point>
<Point> 16.20448267 -9.933012702 </Point>
<Point> 0.6160254038 -0.9330127019 </Point>
</Fixedpointlist>
<Measuredpointlist>
<Point> 6.391460946 -1.929664907 </Point>
</Measuredpointlist>
</Berkeley:Geometry>
</Berkeley:DDA>
