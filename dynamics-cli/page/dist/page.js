/*! This script holds the following works.

three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var hx=Object.defineProperty;var ux=(n,e,t)=>e in n?hx(n,e,{enumerable:!0,configurable:!0,writable:!0,value:t}):n[e]=t;var up=(n,e,t)=>ux(n,typeof e!="symbol"?e+"":e,t);function H(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))s.startsWith("on")?i.addEventListener(s.slice(2),r):s==="class"?i.className=r:s.includes("-")||!(s in i)?i.setAttribute(s,r):i[s]=r;return i.append(...t.flat(1/0).filter(s=>s!=null)),i}function fn(n,e){let t=H("i",{},n);return e===null?[t]:[t,H("sub",{},String(e))]}function dp(n){return H("data",{"data-key":n})}function fp(n,e,t){n.value=String(e),n.title=String(e),n.textContent=t}var mu=180/Math.PI;function mr(n){if(Number.isNaN(n))return"\u2013";if(!Number.isFinite(n))return String(n);let e=Math.abs(n);if(e<5e-13)return"0";if(e<.001||e>=1e6)return n.toExponential(2);let t=e<10?4:e<100?3:e<1e3?2:1;return n.toFixed(t)}function mt(n,e=4){return String(Number(n.toPrecision(e)))}function dx(n){for(let e of[1,2,3,4,6,12]){let t=n/Math.PI*e,i=Math.round(t);if(i===0||Math.abs(t-i)>1e-9)continue;let s=i<0?"-":"",r=Math.abs(i)===1?"":String(Math.abs(i));return`${s}${r}\u03C0${e===1?"":`/${e}`}`}return null}function gu(n){let e=n?"\xB0":"rad";return{inDegrees:n,angleUnit:e,factor:i=>i==="revolute"&&n?mu:1,position:i=>i==="revolute"?e:"m",velocity:i=>i==="revolute"?`${e}/s`:"m/s",acceleration:i=>i==="revolute"?`${e}/s\xB2`:"m/s\xB2",force:i=>i==="revolute"?"N m":"N",angle:i=>n?`${mt(i*mu)}\xB0`:`${mt(i)} rad`,length:i=>`${mt(i)} m`,number:i=>Math.abs(i)<1e-12?"0":mt(i),cell:i=>n?mt(i*mu,6):dx(i)??mt(i,6)}}var Oe=(n,e)=>[n[0]+e[0],n[1]+e[1],n[2]+e[2]],Pt=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],be=(n,e)=>[e*n[0],e*n[1],e*n[2]],hi=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],Gt=n=>Math.hypot(n[0],n[1],n[2]),Qi=(n,e)=>Gt(Pt(n,e)),pn=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],On=n=>be(n,1/(Gt(n)||1));function gr(n,e,t){let[i,s]=[Math.sin(t),Math.cos(t)],r=be(e,hi(e,n)*(1-s));return Oe(Oe(be(n,s),be(pn(e,n),i)),r)}var ks={x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]};function zs(n,e){return Oe(Oe(be(n.x,e[0]),be(n.y,e[1])),be(n.z,e[2]))}function _r(n,e){return Oe(n.o,zs(n,e))}function _u({x:n,y:e,z:t,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:Oe(be(n,a),be(e,o)),y:Pt(be(e,a),be(n,o)),z:t,o:Oe(i,be(t,s))}}function xu({x:n,y:e,z:t,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:n,y:Oe(be(e,a),be(t,o)),z:Pt(be(t,a),be(e,o)),o:Oe(i,be(n,s))}}function es(n,{xyz:e,rpy:t}){let[i,s,r]=t.map(Math.sin),[o,a,l]=t.map(Math.cos);return{x:zs(n,[l*a,r*a,-s]),y:zs(n,[l*s*i-r*o,r*s*i+l*o,a*i]),z:zs(n,[l*s*o+r*i,r*s*o-l*i,a*o]),o:_r(n,e)}}function Qr(n){let e=Math.atan2(-n[2][0],Math.hypot(n[0][0],n[1][0]));return Math.hypot(n[0][0],n[1][0])<1e-9?[0,e,Math.atan2(-n[0][1],n[1][1])]:[Math.atan2(n[2][1],n[2][2]),e,Math.atan2(n[1][0],n[0][0])]}function pp(n){if(n.length===1)return n[0];let{x:e,y:t,z:i,o:s}=n.reduce(es,ks),r=Qr([0,1,2].map(a=>[e[a],t[a],i[a]])),o=a=>a.map(l=>Math.abs(l)<1e-15?0:l);return{xyz:o(s),rpy:o(r)}}function yl(n,e){let t=(i,s)=>n[3*i]*e[s]+n[3*i+1]*e[3+s]+n[3*i+2]*e[6+s];return[0,1,2].flatMap(i=>[0,1,2].map(s=>t(i,s)))}var vu=n=>[n[0],n[3],n[6],n[1],n[4],n[7],n[2],n[5],n[8]],xr=(n,e)=>[0,3,6].map(t=>n[t]*e[0]+n[t+1]*e[1]+n[t+2]*e[2]),yu=n=>n===0?1:Math.sin(n)/n;function Su(n){let e=Gt(n),[t,i]=[yu(e),yu(e/2)**2/2],s=[[1,0,0],[0,1,0],[0,0,1]].map(r=>{let o=pn(n,r);return Oe(Oe(r,be(o,t)),be(pn(n,o),i))});return vu(s.flat())}function mp(n){let e=be([n[7]-n[5],n[2]-n[6],n[3]-n[1]],.5),t=Math.atan2(Gt(e),(n[0]+n[4]+n[8]-1)/2);return be(e,1/yu(t))}function fx(n){let e=n*n;return n<.01?1/12+e*(1/720+e/30240):(1-n/2/Math.tan(n/2))/e}function Mu(n,e){let t=pn(n,e);return Oe(Oe(e,be(t,.5)),be(pn(n,t),fx(Gt(n))))}var eo=[0,1,2,3,4,5].map(n=>{let e="xyz"[n%3];return n<3?{name:`base.v${e}`,axis:e,velocity:"v",force:"f",type:"prismatic"}:{name:`base.w${e}`,axis:e,velocity:"\u03C9",force:"n",type:"revolute"}}),Sl=["x","y","z","roll","pitch","yaw"].map((n,e)=>({name:n,type:e<3?"prismatic":"revolute"})),gp=n=>n.slice(0,9),_s=n=>n.slice(9,12);function _p([n,e,t,...i]){let s=es(ks,{xyz:[n,e,t],rpy:i});return[0,1,2].flatMap(r=>[s.x[r],s.y[r],s.z[r]]).concat(s.o)}function xp(n){let[e,t,i]=[0,1,2].map(s=>[n[s],n[3+s],n[6+s]]);return{x:e,y:t,z:i,o:_s(n)}}var vl=class{constructor(e){this.rotation=gp(e),this.start=[0,0,0,..._s(e)]}pose(e){return[...yl(this.rotation,Su(e.subarray(0,3))),...e.subarray(3,6)]}rate(e,t,i){return[...Mu(e.subarray(0,3),i.slice(3,6)),...xr(t,i)]}recenter(e){this.rotation=gp(this.pose(e)),e.fill(0,0,3)}};function bu(n,e,t,i){let[s,r]=[e-n,n-t];return i*(n+(1-i)*(s*(1-i)+r*i))}function yp([n,e],[t,i],s,r){let o=mp(yl(vu(n),e)),a=(d,u,m)=>d.map((g,x)=>bu(g,s*u[x],s*m[x],r)),l=a(o,t.slice(3,6),Mu(o,i.slice(3,6))),c=Oe(_s(e),be(_s(n),-1)),h=a(c,xr(n,t),xr(e,i));return[...yl(n,Su(l)),...Oe(_s(n),h)]}var px="\u0307",Ml=n=>({min:()=>-n,max:()=>n}),to=({state:n,changed:e},t,i)=>({get:()=>n[t][i],set(s){n[t][i]=s,e()}}),wu=({units:n},e)=>({factor:()=>n().factor(e),unit:()=>n().position(e)}),Eu=n=>({state:n.state,changed:n.changed,units:()=>n.units});function vp(n,e,{signs:t,name:i,most:s}){let{state:r}=n,{type:o}=n.freedoms[e],a=Eu(n),l={...Ml(2*s.speed),...wu(a,o),...to(a,"qd",e),unit:()=>n.units.velocity(o),label:t.velocity,key:`qd-${e}`,about:`${i}, velocity${r.mode==="pose"?"":" at the start"}`};if(r.mode==="pose"){let h={...l,...Ml(4*s.speed),...to(a,"qdd",e),unit:()=>n.units.acceleration(o),label:t.acceleration,key:`qdd-${e}`,about:`${i}, acceleration`};return[l,h]}if(r.law!=="constant")return[l];let c={...Ml(s.force),...to(a,"torque",e),factor:()=>1,unit:()=>n.units.force(o),label:t.force,key:`tau-${e}`,about:`${i}, ${o==="revolute"?"torque":"force"}`};return[l,c]}function Sp(n,e){let{state:t}=n,i=n.joints[e],[s,r]=n.ranges[e],o=Eu(n),a={min:()=>s,max:()=>r,...wu(o,i.type)},l={...a,...to(o,"q",e),label:t.mode==="motion"||t.mode==="reach"?"start":fn("q",null),key:`q-${e}`,about:`${i.name}, position${t.mode==="pose"?"":" at the start"}`};if(t.mode==="reach")return[l];if(t.mode==="motion"){let u={...a,...to(o,"end",e),label:"end",key:`end-${e}`,about:`${i.name}, position at the end`};return[l,u]}let c=Math.max(1,...n.table.rows.map(u=>u.mass))*9.81,h={velocity:fn("q\u0307",null),acceleration:fn("q\u0308",null),force:fn("\u03C4",null)},d=i.type==="revolute"?{speed:Math.PI,force:c*n.size}:{speed:n.size,force:c};return[l,...vp(n,n.ofBase+e,{signs:h,name:i.name,most:d})]}function Mp(n){let{state:e,size:t}=n,i=Eu(n),s=Sl.map(({name:c,type:h},d)=>({...Ml(h==="revolute"?Math.PI:Math.max(2*t,1)),...wu(i,h),...to(i,"pose",d),label:c,key:`pose-${d}`,about:`base, ${c}${e.mode==="free"?" at the start":""}`}));if(e.mode==="motion"||e.mode==="reach")return s;let{rows:r,floating:o}=n.table,a=9.81*r.reduce((c,{mass:h})=>c+h,o.mass),l=n.freedoms.slice(0,n.ofBase).map(({name:c,axis:h,velocity:d,force:u,type:m},g)=>{let x={velocity:fn(d,h),acceleration:fn(`${d}${px}`,h),force:fn(u,h)},f=m==="revolute"?{speed:Math.PI,force:a*t}:{speed:Math.max(2*t,2),force:2*a};return vp(n,g,{signs:x,name:c,most:f})});return[...s,...l.map(([c])=>c),...l.flatMap(([,c])=>c??[])]}var yr=class extends Error{constructor(e){super(`not positive definite at index ${e}`),this.joint=e}};function Vs(n,e,t){let i=t.length,s=t.map(()=>new Array(i).fill(0)),r=t.map(o=>e[o]);for(let o=0;o<i;o++){for(let a=0;a<=o;a++){let l=n[t[o]][t[a]];for(let c=0;c<a;c++)l-=s[o][c]*s[a][c];if(o===a&&!(l>1e-14*Math.abs(n[t[o]][t[o]])))throw new yr(t[o]);s[o][a]=o===a?Math.sqrt(l):l/s[a][a]}for(let a=0;a<o;a++)r[o]-=s[o][a]*r[a];r[o]/=s[o][o]}for(let o=i-1;o>=0;o--){for(let a=o+1;a<i;a++)r[o]-=s[a][o]*r[a];r[o]/=s[o][o]}return r}var Tu=eo.map((n,e)=>e),bp={none:()=>(n,e,t)=>t.map(()=>0),constant:({torque:n})=>()=>n,gravity:({equations:n})=>(e,t)=>{let i=n.spring_vector(t);return n.gravity_vector(e,t).map((s,r)=>s+i[r])},steady:({equations:n,hasFriction:e})=>(t,i,s)=>{let r=n.inverse_dynamics(t,i,s,s.map(()=>0)),o=n.mass_matrix(i),a=Vs(o,r.map(c=>-c),Tu),l=e?null:n.friction_vector(s);return r.map((c,h)=>h<Tu.length?0:Tu.reduce((d,u)=>d+o[h][u]*a[u],c-(l?.[h]??0)))}};function wp({floating:n}){let e="none: free fall";return n?{none:e,steady:"of joints: they keep their velocities",constant:"constant, on the base too",gravity:"G + K, on the base too: the robot floats"}:{none:e,constant:"constant",gravity:"G + K: the arm floats"}}function Pi(n,e){return H("div",{class:"scroll",role:"region",tabIndex:0,"aria-label":n},e)}var sa=(n,e,t="")=>H("table",{class:`numbers${t}`},n&&H("caption",{},n),H("tbody",{},e.map(i=>H("tr",{},i)))),no=(...n)=>H("th",{scope:"row"},n),ra=n=>H("i",{},n),bl=(n,e="")=>H("td",{class:`unit${e}`},n);function Ep(n){let{joints:e,freedoms:t,ofBase:i,table:s}=n,r=s.rows.some(R=>R.viscous||R.coulomb.some(Boolean)||R.stribeck),o=s.rows.some(R=>R.spring),a=[{key:"q",sign:"q",unit:"position",isAngle:!0},{key:"qd",sign:"q\u0307",unit:"velocity",isAngle:!0},{key:"qdd",sign:"q\u0308",unit:"acceleration",isAngle:!0},{key:"tau",sign:"\u03C4",unit:"force"},{key:"coriolis",sign:"V",unit:"force"},{key:"gravity",sign:"G",unit:"force"},...o?[{key:"spring",sign:"K",unit:"force"}]:[],...r?[{key:"friction",sign:"F",unit:"force"}]:[]],l=new Map,c=R=>{let U=dp(R);return l.set(R,U),H("td",{},U)},h=[...new Set(t.map(R=>R.type))],d=a.map(()=>H("th",{class:"unit",scope:"col"})),u=H("table",{class:"numbers wide"},H("caption",{},"State and forces"),H("thead",{},H("tr",{},H("th",{scope:"col"},"joint"),a.map(R=>H("th",{scope:"col"},ra(R.sign)))),H("tr",{},H("th",{class:"unit",scope:"col"},""),d)),H("tbody",{},t.map((R,U)=>{let k=U-i,z=no(H("span",{class:"dot"}),k<0?["base ",fn(R.velocity,R.axis)]:R.name);z.style.setProperty("--color",k<0?`var(--axis-${R.axis})`:`var(--joint-${k%8})`);let $=a.map(({key:X})=>X!=="q"?c(`${X}-${U}`):k<0?H("td"):c(`q-${k}`));return H("tr",{},z,$)}))),g=h.length>1?"kg m\xB2, kg m, kg":h[0]==="revolute"?"kg m\xB2":"kg",x=sa(["Mass matrix ",ra("M"),`, ${g}`],t.map((R,U)=>t.map((k,z)=>c(`mass-${U}-${z}`)))," matrix"),f=H("span",{},"Tip"),p=["x","y","z"],M=(R,U,k)=>sa([R," in the world"],p.map((z,$)=>[no(ra(z)),c(U($)),bl("m"),no(["roll","pitch","yaw"][$]),c(k($)),bl(null," angle")])),C=M(f,R=>`tip-${R}-3`,R=>`rpy-${R}`),y=i>0?M("Base",R=>`base-${R}`,R=>`baserpy-${R}`):null,T=[0,1,2,3].map(R=>[0,1,2,3].map(U=>c(`T-${R}-${U}`))),b=H("details",{},H("summary",{},"Transform of the tip, 4 \xD7 4"),Pi("Transform of the tip",sa(null,T," matrix"))),_=Object.entries({T:"kinetic",U:"potential","T + U":"total"}),v=sa("Energies, J",_.map(([R,U])=>[no(ra(R)),c(U)])),D=()=>sa(["Momentum in the world; ",ra("L")," about the centre of mass"],p.map((R,U)=>[no(fn("p",R)),c(`linear-${U}`),bl("kg m/s"),no(fn("L",R)),c(`angular-${U}`),bl("kg m\xB2/s")])),P=(R,U,k=1)=>fp(l.get(R),U,mr(U*k));function I(){let{units:R}=n,U=n.evaluated();s.tips.length>1&&(f.textContent=n.tip().name),a.forEach(({key:z,isAngle:$})=>{(z==="q"?e:t).forEach((Z,te)=>P(`${z}-${te}`,U[z][te],$?R.factor(Z.type):1))});let k=U.mass.map((z,$)=>Math.abs(z[$]));if(t.forEach((z,$)=>t.forEach((X,Z)=>{P(`mass-${$}-${Z}`,U.mass[$][Z]);let te=Math.abs(U.mass[$][Z])/Math.sqrt(k[$]*k[Z]);l.get(`mass-${$}-${Z}`).parentElement.style.setProperty("--share",Number.isFinite(te)?Math.min(te,1).toFixed(3):0)})),U.tip.forEach((z,$)=>z.forEach((X,Z)=>P(`T-${$}-${Z}`,X))),[0,1,2].forEach(z=>P(`tip-${z}-3`,U.tip[z][3])),Qr(U.tip).forEach((z,$)=>P(`rpy-${$}`,z,R.factor("revolute"))),U.base){_s(U.base).forEach(($,X)=>P(`base-${X}`,$));for(let $ of["linear","angular"])U.momentum[$].forEach((X,Z)=>P(`${$}-${Z}`,X));let z=[0,3,6].map($=>U.base.slice($,$+3));Qr(z).forEach(($,X)=>P(`baserpy-${X}`,$,R.factor("revolute")))}P("kinetic",U.kinetic),P("potential",U.potential),P("total",U.kinetic+U.potential)}function L(){a.forEach(({unit:R},U)=>{d[U].textContent=h.map(k=>n.units[R](k)).join(", ")}),O.querySelectorAll(".angle").forEach(R=>R.textContent=n.units.angleUnit),I()}let O=H("div",{class:"blocks"},Pi("Mass matrix",x),y&&Pi("Pose of the base",y),Pi("Pose of the tip",C),Pi("Energies",v),i>0?Pi("Momentum",D()):null);return n.on("units",L),n.on("time tip",I),L(),H("section",{class:"panel","aria-label":"Numbers"},Pi("State and forces",u),O,b)}function io({label:n,key:e,min:t,max:i,get:s,set:r,factor:o,unit:a,about:l}){let c=H("input",{type:"range",step:"any","data-key":e,"aria-label":l}),h=H("input",{type:"number",step:"any","aria-label":`${l}, as a number`}),d=H("span",{class:"unit"}),u=H("p",{class:"refused",role:"alert"}),m=H("div",{class:"slider"},H("span",{class:"what"},n),c,h,d,u),g=()=>{let[f,p]=[s(),o()],[M,C]=[Math.min(t(),f),Math.max(i(),f)];Object.assign(c,{min:M*p,max:C*p}),c.value=f*p,c.setAttribute("aria-valuetext",`${mt(f*p)} ${a()}`),(document.activeElement!==h||u.textContent)&&(h.value=mt(f*p,5)),d.textContent=a()},x=f=>{let p=Number(f)/o(),M=f.trim()!==""&&Number.isFinite(p),C=M?r(p):"expected a number";u.textContent=C?`${M?`${f} is refused: `:""}${C}`:"",g()};return c.addEventListener("input",()=>x(c.value)),h.addEventListener("change",()=>x(h.value)),g(),{row:m,show:g}}function mx(n){let{state:e,size:t}=n;return Sl.slice(0,e.hasRotation?6:3).map(({name:i,type:s},r)=>{let o=s==="revolute"?Math.PI:1.2*t;return io({label:i,key:`target-${r}`,about:`target, ${i}`,min:()=>-o,max:()=>o,get:()=>e.target[r],set(a){e.target[r]=a,n.seek()},factor:()=>n.units.factor(s),unit:()=>n.units.position(s)})})}function Tp(n){let{state:e,joints:t}=n,i=mx(n),s=H("input",{type:"checkbox",checked:e.hasRotation,"data-key":"rotation"});s.addEventListener("change",()=>{e.hasRotation=s.checked,n.seek(),n.tell("mode")});let r=H("div",{class:"head"},H("span",{class:"name"},H("b",{},"target"),` of ${n.tip().name}`),H("label",{class:"check"},s,"with its rotation")),o=H("p",{class:"said","data-key":"reached",role:"status"}),a=H("table",{class:"numbers solutions"}),l=(g,x,f)=>H("button",{type:"button",class:"chip","data-key":x,onclick:f},g),c=(g,x)=>H("tr",{class:x===e.reached.chosen?"chosen":""},H("th",{scope:"row"},String(x+1)),H("td",{},l("start",`start-${x}`,()=>n.choose(x,!0)),l("end",`solution-${x}`,()=>n.choose(x))),g.map((f,p)=>H("td",{},H("data",{value:String(f),title:String(f)},mr(f*n.units.factor(t[p].type))))));function h(){let{found:g,missing:x}=e.reached;a.hidden=g.length===0;let f=["","of the motion",...t.map(({name:p,type:M})=>`${p}, ${n.units.position(M)}`)];a.replaceChildren(H("thead",{},H("tr",{},f.map(p=>H("th",{scope:"col"},p)))),H("tbody",{},g.map(c))),o.classList.toggle("refused",x!==null),o.textContent=x?d(x):`${g.length} ${g.length===1?"solution":"solutions"} found: the motion goes to that which is marked.`}function d({way:g,turn:x}){let{factor:f,angleUnit:p}=n.units,M=2*Math.asin(Math.min(1,x/2))*f("revolute"),C=e.hasRotation?` and ${mt(M,3)} ${p}`:"";return`No solution found: ${mt(g,3)} m${C} are missing at the nearest positions, to which the motion goes.`}function u(){i.forEach(g=>g.show()),h()}return u(),{group:H("div",{class:"joint base"},r,i.map(g=>g.row),o,Pi("Solutions",a)),show:u}}var gx={motion:"Motion",reach:"Reach",free:"Free motion",pose:"Pose"},_x={motion:"From start to end, from rest to rest; inverse dynamics gives the torques.",reach:"From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",free:"From the start under given torques; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes."},xx={motion:"The base is held where it is, and the joints go from start to end, from rest to rest; inverse dynamics gives the torques, and the force and the moment that hold the base.",reach:"The base is held where it is. From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",free:"Base and joints move freely from the start; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes, and the force and the moment on the base."};function yx(n,{name:e,value:t,unit:i}){let s=i==="rad",[r,o]=s?[-Math.PI,Math.PI]:t<0?[3*t,0]:[0,3*t||1];return io({label:H("i",{},e),key:`field-${e}`,about:i?`field ${e}`:`field ${e}, without unit`,min:()=>r,max:()=>o,get:()=>n.fields[e],set:a=>n.setFields({[e]:a}),factor:()=>s?n.units.factor("revolute"):1,unit:()=>s?n.units.angleUnit:i})}function vx({about:n,key:e,options:t,get:i,set:s}){let r=Object.entries(t).map(([a,l])=>H("option",{value:a},l)),o=H("select",{"data-key":e,onchange:()=>s(o.value)},r);return o.value=i(),H("label",{class:"choice"},H("span",{},n),o)}function Sx({rows:n},e){let{on:t}=n[e];return n.filter(s=>!s.isPlace&&s.on===t).length>1||(t??-1)!==e-1?`on ${t===null?"the base":n[t].name}`:null}function Ap(n){let{state:e,joints:t,first:i}=n,s=[],o=Object.entries(gx).filter(([L])=>L!=="reach"||t.length>0).map(([L,O])=>H("button",{type:"button",role:"tab","data-key":`mode-${L}`,onclick:()=>n.setMode(L)},O)),a=H("div",{class:"tabs",role:"tablist","aria-label":"Kind of motion"},o);a.addEventListener("keydown",({key:L})=>{let O={ArrowRight:1,ArrowLeft:-1}[L];if(!O)return;let R=o.findIndex(k=>k.getAttribute("aria-selected")==="true"),U=o[(R+O+o.length)%o.length];U.focus(),U.click()});let l=H("p",{class:"said"}),c=H("div",{class:"settings"}),h=H("div",{class:"joints"}),d=H("div",{role:"tabpanel"},l,c,h),u=H("input",{type:"number",min:"0.1",max:"60",step:"any","data-key":"duration"}),m=H("p",{class:"refused",role:"alert"});u.addEventListener("change",()=>{let L=Number(u.value);m.textContent=L>0?"":"expected a number above zero",L>0&&(e.duration=Math.min(L,60)),u.value=e.duration,n.changed()});let g={cycloidal:"cycloidal",quintic:"quintic polynomial",cubic:"cubic polynomial"},x={joints:"each joint by itself",line:"straight line of the tip"},f=wp(n.table),p=n.table.floating?xx:_x,M=n.table.rows.some(L=>L.viscous!==0||L.coulomb.some(O=>O!==0)||L.stribeck),C=null;function y(){o.forEach(R=>{let U=R.dataset.key===`mode-${e.mode}`;R.setAttribute("aria-selected",U),R.tabIndex=U?0:-1}),l.textContent=p[e.mode],u.value=e.duration;let L=[];e.mode!=="pose"&&L.push(H("label",{class:"choice"},H("span",{},"duration, s"),u),m);let O=(R,U,k)=>{let z=$=>{e[U]=$,U==="law"&&y(),n.changed()};L.push(vx({about:R,key:U,options:k,get:()=>e[U],set:z}))};if((e.mode==="motion"||e.mode==="reach")&&O("profile","profile",g),e.mode==="reach"&&O("way","path",x),e.mode==="free"&&(O("torques","law",f),M)){let R=H("input",{type:"checkbox",checked:e.hasFriction,"data-key":"friction"});R.addEventListener("change",()=>{e.hasFriction=R.checked,n.changed()}),L.push(H("label",{class:"check"},R,"friction"))}c.replaceChildren(...L),s.length=0,C=e.mode==="reach"?Tp(n):null,h.replaceChildren(...C?[C.group]:[],...n.table.floating?[T()]:[],...t.flatMap((R,U)=>{let k=Sp(n,U).map(io);s.push(...k);let z=n.table.rows.findIndex(Q=>Q.joint===U),$=H("button",{type:"button",class:"name",onclick:()=>n.select(z)});$.append(H("span",{class:"dot"}),H("b",{},String(U+1)),` ${R.name}`);let X=H("span",{class:"kind"},R.type),Z=H("span",{class:"kind limits"}),te=H("div",{class:"head"},$,X,Z),oe=H("div",{class:"joint","data-joint":U},te,k.map(Q=>Q.row));oe.addEventListener("focusin",()=>n.select(z));let ce=Sx(n.table,z);return ce===null?oe:[H("h3",{class:"branch"},ce),oe]})),_(),b()}function T(){let L=Mp(n).map(io);s.push(...L);let O=H("span",{class:"name"},H("b",{},"base")),R=H("span",{class:"kind"},"velocities and forces in its own axes");return H("div",{class:"joint base"},H("div",{class:"head"},O,R),L.map(U=>U.row))}function b(){let{factor:L,position:O}=n.units;h.querySelectorAll(".limits").forEach((R,U)=>{let{limits:k,type:z}=t[U],$=k?.map(X=>mt(X*L(z),4));R.textContent=$?`${$[0]} to ${$[1]} ${O(z)}`:"no limits"})}function _(){h.querySelectorAll("[data-joint]").forEach((L,O)=>{let{selected:R}=e;L.classList.toggle("selected",n.table.rows[R]?.joint===O),L.style.setProperty("--color",`var(--joint-${O%8})`)})}let v=i.fields.map(L=>yx(n,L)),D=H("div",{class:"fields"},H("h3",{},"Parameters"),v.map(L=>L.row));n.on("mode",y),n.on("units",()=>{[...s,...v,...C?[C]:[]].forEach(L=>L.show()),b()}),n.on("selection",_),n.on("reached",()=>{s.forEach(L=>L.show()),C?.show()}),n.on("tip",()=>e.mode==="reach"&&y()),y();let P=H("button",{type:"button",class:"quiet",onclick(){let L=k=>e[k].fill(0);["qdd","torque"].forEach(L),["pose","qd"].forEach(k=>I[k].forEach((z,$)=>e[k][$]=z));let{from:O,to:R,duration:U}=i;I.q.forEach((k,z)=>e.q[z]=O?.[z]??k),I.end.forEach((k,z)=>e.end[z]=R?.[z]??k),e.duration=U,n.setFields(Object.fromEntries(i.fields.map(({name:k,value:z})=>[k,z]))),y(),v.forEach(k=>k.show()),n.changed()}});P.append("Reset");let I={q:[...e.q],end:[...e.end],pose:[...e.pose],qd:[...e.qd]};return H("section",{class:"panel controls","aria-label":"Settings"},H("div",{class:"bar"},a,P),d,i.fields.length>0?D:null)}var Mx=[[0,1],[0,2],[1,2]];function bx([n,e,t,i,s,r]){let o=[[n,i,r],[i,e,s],[r,s,t]],a=[[1,0,0],[0,1,0],[0,0,1]];for(let l=0;l<12;l++)for(let[c,h]of Mx){if(o[c][h]===0)continue;let d=Math.atan2(2*o[c][h],o[h][h]-o[c][c])/2,[u,m]=[Math.sin(d),Math.cos(d)],g=x=>x.forEach(f=>[f[c],f[h]]=[m*f[c]-u*f[h],u*f[c]+m*f[h]]);g(o),[o[c],o[h]]=[o[c].map((x,f)=>m*x-u*o[h][f]),o[c].map((x,f)=>u*x+m*o[h][f])],g(a)}return{moments:[o[0][0],o[1][1],o[2][2]],axes:a}}function wl({mass:n,inertia:e}){let{moments:t,axes:i}=bx(e),s=t[0]+t[1]+t[2],r=t.map(c=>n>0?Math.sqrt(Math.max(0,6*(s-2*c)/n))/2:0),[o,a,l]=[0,1,2].map(c=>i.map(h=>h[c]));return{x:o,y:a,z:l,half:r}}function wx(n,e){return n.rows.map(t=>t.joint!==null?e[t.joint]:t.follows?t.follows.factor*e[t.follows.joint]+t.follows.offset:t.locked)}function Ii(n,e,t){let i=t?xp(t):n.base?es(ks,n.base):ks,s=wx(n,e),r=[];n.rows.forEach((a,l)=>{let c=a.on===null?i:r[a.on].frame,h=a.step.reduce(es,c),d=a.type==="prismatic",u=a.theta+(d?0:s[l]),m=a.d+(d?s[l]:0),g=(f,p,M)=>{let C=a.mount?a.mount.frame.reduce(es,p):p;r.push({before:h,middle:f,frame:p,link:C,theta:u,d:m,origin:M.o,axis:M.z})};if(n.convention==="standard"){let f=_u(h,m,u);g(f,xu(f,a.a,a.alpha),h);return}let x=xu(h,a.a,a.alpha);g(x,_u(x,m,u),x)});let o=n.tips.map(({on:a,places:l})=>l.reduce(es,a===null?i:r[a].link));return{base:i,rows:r,tips:o}}function Rp(n,e){let t=new Array(n.joints).fill(0),{base:i,rows:s,tips:r}=Ii(n,t,null),o=[],a=u=>u===null?{way:0,at:i.o}:o[u],l=({way:u,at:m},g)=>({way:u+Qi(m,g),at:g});s.forEach(({middle:u,frame:m,link:g},x)=>{let{on:f,isPlace:p}=n.rows[x],M=n.isMounted?p?[]:[g.o]:[u.o,m.o];o.push(M.reduce(l,a(f)))});let c=n.tips.map(({on:u},m)=>l(a(u),r[m].o).way),h=Math.max(0,...o.map(({way:u})=>u),...c)+e,d=n.rows.map(u=>Math.hypot(...u.com));if(n.floating){let{com:u}=n.floating;d.push(Gt(Oe(u,wl(n.floating).half)))}return Math.max(h,...d)||1}function Cp(n,e,t){let i=e.slice(0,6).map(a=>a.reduce((l,c,h)=>l+c*t[h],0)),[s,r]=[i.slice(0,3),i.slice(3)],o=be([e[1][5],e[2][3],e[0][4]],1/(e[0][0]||1));return{linear:xr(n,s),angular:xr(n,Pt(r,pn(o,s)))}}var Ex=["mass_matrix","coriolis_vector","kinetic_energy","friction_vector","spring_vector"];function Pp(n,e,t){let i=Object.keys(n).filter(o=>/^[a-z]/.test(o)),s=n.FIELD_NAMES!==void 0,r=o=>{let a=s?(...l)=>n[o](e,...l):n[o];return t||Ex.includes(o)?a:(l,...c)=>a(...c)};return Object.fromEntries(i.map(o=>[o,r(o)]))}function Ip(n,{base:e,q:t,qd:i,qdd:s,tau:r},{key:o}){let a=n.gravity_vector(e,t),l=n.friction_vector(i),c=n.spring_vector(t),h=n.mass_matrix(t),d=n.inverse_dynamics(e,t,i,i.map(()=>0));return{base:e,q:t,qd:i,qdd:s,tau:r,mass:h,momentum:e&&Cp(e,h,i),coriolis:d.map((u,m)=>u-a[m]-c[m]-l[m]),gravity:a,friction:l,spring:c,tip:n[o](e,t),kinetic:n.kinetic_energy(t,i),potential:n.potential_energy(e,t)}}var oa=2*Math.PI,Au={cycloidal:n=>[n-Math.sin(oa*n)/oa,1-Math.cos(oa*n),oa*Math.sin(oa*n)],quintic:n=>[n**3*(10+n*(6*n-15)),30*n**2*(1-n)**2,60*n*(1-n)*(1-2*n)],cubic:n=>[n*n*(3-2*n),6*n*(1-n),6-12*n]};function Lp({from:n,to:e,duration:t,profile:i},s){let[r,o,a]=Au[i](Math.min(Math.max(s/t,0),1)),l=c=>n.map((h,d)=>c(e[d]-h,h));return{q:l((c,h)=>h+c*r),qd:l(c=>c*o/t),qdd:l(c=>c*a/t**2)}}var Dp=1e-9,[El,Tx]=[5,60],[Np,Up]=[.1,1e-12],Ax=1e-9,[Rx,Cx]=[120,.001],Ru=["x","y","z"];function Pu(n,e){let t=Ru.map(a=>pn(n[a],e[a])).reduce(Oe),i=1+Ru.reduce((a,l)=>a+hi(n[l],e[l]),0);if(i>1e-6)return be(t,1/Math.sqrt(i));let s=a=>Ru.reduce((l,c)=>Oe(l,be(e[c],n[c][a])),[0,1,2].map(l=>l===a?1:0)),o=[0,1,2].map(s).reduce((a,l)=>Gt(l)>Gt(a)?l:a);return be(o,2/Gt(o))}function Fp(n,e){let t=new Set;for(let i=n.tips[e].on;i!==null;i=n.rows[i].on)t.add(n.rows[i].joint??n.rows[i].follows?.joint);return t.delete(void 0),t.size}function Tl({table:n,base:e,tip:t},i){let{rows:s,tips:r}=Ii(n,i,e),o=i.map(()=>[0,0,0,0,0,0]);for(let a=n.tips[t].on;a!==null;a=n.rows[a].on){let{joint:l,follows:c,type:h}=n.rows[a],{joint:d,factor:u}=l===null?c??{joint:null}:{joint:l,factor:1};if(d===null)continue;let{axis:m,origin:g}=s[a],x=h==="prismatic"?[...m,0,0,0]:[...pn(m,Pt(r[t].o,g)),...m];o[d]=o[d].map((f,p)=>f+u*x[p])}return{frame:r[t],columns:o}}function Cu(n,e){let{target:t,size:i,hasRotation:s}=n,{frame:r,columns:o}=Tl(n,e),a=Pt(t.o,r.o),l=s?Pu(r,t):[0,0,0],c=[1,1,1].map(m=>m/i).concat(s?[1,1,1]:[0,0,0]),h=[...a,...l].map((m,g)=>m*c[g]),d=o.map(m=>m.map((g,x)=>g*c[x])),u=(m,g)=>m.reduce((x,f,p)=>x+f*g[p],0);return{way:Gt(a),turn:Gt(l),isReached:Gt(a)<=Dp&&Gt(l)<=Dp,error:u(h,h)/2,descent:d.map(m=>u(m,h)),matrix:d.map(m=>d.map(g=>u(m,g)))}}var Op=({matrix:n})=>Math.max(0,...n.map((e,t)=>e[t]));function Bp({limits:n},{matrix:e,descent:t},i,s){let r=e.map((l,c)=>l.map((h,d)=>c===d?h+i:h)),o=s.map(()=>0),a=s.map((l,c)=>c);for(let l=0;l<4&&a.length>0;l++){let c=t.map((u,m)=>s.reduce((g,x,f)=>a.includes(f)?g:g-r[m][f]*o[f],u)),h;try{h=Vs(r,c,a)}catch(u){if(u instanceof yr)return null;throw u}a.forEach((u,m)=>o[u]=aa(s[u]+h[m],n[u])-s[u]);let d=a.filter((u,m)=>o[u]===s[u]+h[m]-s[u]);if(d.length===a.length)break;a=d}return s.map((l,c)=>aa(l+o[c],n[c]))}var aa=(n,e)=>e?Math.min(Math.max(n,e[0]),e[1]):n;function zp(n,e){let t=e.map((s,r)=>aa(s,n.limits[r])),i=1/0;for(let s=0;;s++){let r=Cu(n,t),o=s%El===El-1&&!(r.error<i/2);if(r.isReached||o||s===Tx)return{q:t,...r};s%El===El-1&&(i=r.error);let a=Op(r),l=Bp(n,r,Np*Math.min(r.error,a)+Up*a,t);if(l===null)return{q:t,...r};t=l}}function kp(n,e){let t=e.map((o,a)=>aa(o,n.limits[a])),i=Cu(n,t),s=Op(i),r=Np*s;for(let o=0;o<200&&!i.isReached&&r<1e9*s;o++){let a=Bp(n,i,r,t);if(a===null)break;let l=Cu(n,a);i.error-l.error<Ax*i.error?r*=4:[t,i,r]=[a,l,Math.max(r/4,Up*s)]}return{q:t,...i}}function Al(n,e){let t=zp(n,e);return t.isReached?t:kp(n,e)}function Px(n){let e=n;return()=>{e=e+1831565813|0;let t=Math.imul(e^e>>>15,1|e);return t=t+Math.imul(t^t>>>7,61|t)^t,((t^t>>>14)>>>0)/2**32}}function Ix({table:n,limits:e},t,i){let s=o=>n.rows.some(({follows:a})=>a?.joint===o),r=n.rows.filter(({joint:o})=>o!==null);return t.map((o,a)=>{if(r[a].type!=="revolute"||s(a))return o;let l=2*Math.PI,c=o-l*Math.round((o-i[a])/l);return[c,c+l,c-l].find(d=>aa(d,e[a])===d)??o})}var Lx=(n,e)=>n.every((t,i)=>[0,2*Math.PI].some(s=>Math.abs(Math.abs(t-e[i])-s)<Cx));function Vp(n,e,t=16){let i=Px(1),s=()=>n.ranges.map(([l,c])=>l+(c-l)*i()),r=[],o=null;for(let l=0;l<Rx&&r.length<t;l++){let c=zp(n,l===0?e:s());if((o===null||c.error<o.error)&&(o=c),!c.isReached)continue;let h=Ix(n,c.q,e);r.some(d=>Lx(h,d))||r.push(h)}let a=l=>Math.max(...l.map((c,h)=>Math.abs(c-e[h])));return r.sort((l,c)=>a(l)-a(c)),{found:r,nearest:r.length>0?null:kp(n,o.q)}}var Iu=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],Rl=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]],[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]]],Gp=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],Hp=[[0,.2440944881889764],[8,.7338466882816118],[11,.022058823529411766]];var Dx=1e-10;function la(n,e,t,i){let s=Float64Array.from(n);for(let[r,o]of t){let a=i[r];for(let l=0;l<s.length;l++)s[l]+=e*o*a[l]}return s}function Cl(n,e,t,i,s){let r=[i];for(let g=1;g<Iu.length;g++)r.push(n(e+Iu[g]*s,la(t,s,Rl[g],r)));let o=la(t,s,Rl[12],r),a=new Float64Array(t.length),l=la(a,1,Rl[12],r),c=la(a,1,Hp,r),h=la(a,1,Gp,r),[d,u]=[0,0];for(let g=0;g<t.length;g++){let x=Dx*(1+Math.max(Math.abs(t[g]),Math.abs(o[g])));d+=(h[g]/x)**2/t.length,u+=((l[g]-c[g])/x)**2/t.length}let m=d===0?0:s*d/Math.sqrt(d+.01*u);return{end:o,error:m}}function Lu(n,e){if(!Number.isFinite(n))return 1/3;let t=.9*n**(-1/8);return Math.min(Math.max(t,1/3),e?1:6)}function Nx(n){let e=Array.from({length:n.dof},()=>[]),t=n.dof-n.joints;for(let i of n.rows)i.joint!==null?e[t+i.joint].push({row:i,factor:1}):i.follows&&e[t+i.follows.joint].push({row:i,factor:i.follows.factor});return e}var Wp=(n,e)=>e>0?n.coulomb[0]:n.coulomb[1],Ux=(n,e)=>n.stribeck?n.stribeck.friction:Wp(n,e);function Xp(n){let e=Nx(n);return{isDry:e.map(t=>t.some(({row:i})=>i.coulomb[0]!==0||i.coulomb[1]!==0||i.stribeck!==null)),breakaway:(t,i)=>e[t].reduce((s,{row:r,factor:o})=>s+Math.abs(o)*Ux(r,i*Math.sign(o)),0),sliding:(t,i,s)=>e[t].reduce((r,{row:o,factor:a})=>{let l=a*s,c=Math.sign(a)*i,h=Wp(o,c),d=o.stribeck?(o.stribeck.friction-h)*Math.exp(-((l/o.stribeck.velocity)**2)):0;return r+a*(o.viscous*l+c*(h+d))},0)}}var Fx=6e5,Ox=200;function Bx(n,e){let t=e-(n.dof-n.joints);if(t<0)return"the mass matrix is singular at the base: no inertia resists its motion";let{name:i}=n.rows.find(s=>s.joint===t);return`the mass matrix is singular at joint ${t+1}, \`${i}\`: no inertia resists its motion`}var so=class extends Error{},Du=class{constructor(e,t,i,s,r){up(this,"rate",(e,t)=>{let i=this.state(t),{base:s,qd:r}=i,{tau:o,friction:a,qdd:l}=this.solve(i),c=r.reduce((h,d,u)=>h+d*(o[u]-a[u]),0);return this.chart?Float64Array.from([...this.chart.rate(t,s,r),...r.slice(this.ofBase),...l,c]):Float64Array.from([...r,...l,c])});this.chart=i&&new vl(i),this.ofBase=t.dof-t.joints,this.equations=e,this.torque=s,this.hasFriction=r,this.dry=Xp(t),this.dof=t.dof,this.evaluations=0,this.contacts=new Array(t.dof).fill(0),this.sticks=r&&this.dry.isDry.some(Boolean)}friction(e){return this.hasFriction?e.map((t,i)=>{let s=this.contacts[i];return s===null?0:this.dry.sliding(i,s||Math.sign(t),t)}):e.map(()=>0)}solve({base:e,q:t,qd:i}){if(++this.evaluations>Fx)throw new so("it takes too many steps");let s=this.torque(e,t,i),r=this.friction(i);if(!this.contacts.includes(null)){let g=this.equations.friction_vector(i),x=s.map((f,p)=>f+(g[p]-r[p]));return{tau:s,friction:r,qdd:this.equations.forward_dynamics(e,t,i,x),hold:null}}let o=i.map(()=>0),a=this.equations.friction_vector(i),l=this.equations.inverse_dynamics(e,t,i,o).map((g,x)=>g-a[x]),c=this.equations.mass_matrix(t),h=this.contacts.flatMap((g,x)=>g===null?[]:[x]),d=s.map((g,x)=>g-l[x]-r[x]),u=o;Vs(c,d,h).forEach((g,x)=>u[h[x]]=g);let m=s.map((g,x)=>this.contacts[x]!==null?0:c[x].reduce((f,p,M)=>f-p*u[M],g-l[x]));return{tau:s,friction:r,qdd:u,hold:m}}state(e){let t=this.dof;return{base:this.chart&&this.chart.pose(e),q:Array.from(e.subarray(this.ofBase,t)),qd:Array.from(e.subarray(t,2*t))}}margins(e){if(!this.sticks)return[1/0];let t=this.state(e),i=this.contacts.includes(null)?this.solve(t).hold:null;return this.contacts.map((s,r)=>s===null?this.dry.breakaway(r,Math.sign(i[r]))-Math.abs(i[r]):s===0?1/0:s*t.qd[r])}settle(e){if(!this.sticks)return;let t=this.state(e);for(this.contacts=t.qd.map((i,s)=>this.dry.isDry[s]?i===0?null:Math.sign(i):0);this.contacts.includes(null);){let{hold:i}=this.solve(t),s=this.contacts.map((o,a)=>o!==null||i[a]===0?0:Math.abs(i[a])/this.dry.breakaway(a,Math.sign(i[a]))),r=s.indexOf(Math.max(...s));if(!(s[r]>1))return;this.contacts[r]=Math.sign(i[r])}}};function zx(n,e,t,i,s){let[r,o]=[0,s];for(let a=0;a<60&&o-r>1e-12*s;a++){let l=(r+o)/2,{end:c}=Cl(n.rate,e,t,i,l);Math.min(...n.margins(c))<0?o=l:r=l}return o}function kx(n,e,t){let{t:i,y:s,h:r}=e,o=0,a=!1;for(;t-i>1e-12*Math.max(1,t);){let l=n.rate(i,s),c=Math.min(r,t-i),{end:h,error:d}=Cl(n.rate,i,s,l,c);if(!(d<=1)){if(r=c*Lu(d,!0),a=!0,!(r>1e-12))throw new so("its steps become too small");continue}if(Math.min(...n.margins(h))<0){if(++o>Ox)throw new so("a joint sticks and lets go without end");let m=zx(n,i,s,l,c);s=Cl(n.rate,i,s,l,m).end,i+=m,n.chart?.recenter(s),n.contacts.forEach((g,x)=>{g&&g*s[n.dof+x]<=0&&(s[n.dof+x]=0)}),n.settle(s);continue}[i,s]=[i+c,h],n.chart?.recenter(s);let u=c*Lu(d,a);r=c<r&&d<.1?Math.max(r,u):u,a=!1}return{t,y:s,h:r}}function qp({equations:n,table:e,law:t,torque:i,hasFriction:s,base:r,q:o,qd:a,duration:l,samples:c}){let h=bp[t]({equations:n,torque:i,hasFriction:s}),d=new Du(n,e,r,h,s),u={t:[],base:[],q:[],qd:[],qdd:[],tau:[],work:[],ended:null},m={t:0,y:Float64Array.from([...d.chart?.start??[],...o,...a,0]),h:l/c};try{d.settle(m.y);for(let g=0;g<c;g++){let x=l*g/(c-1);m=kx(d,m,x);let f=d.state(m.y),{qdd:p,tau:M}=d.solve(f);u.t.push(x),u.base.push(f.base),u.q.push(f.q),u.qd.push(f.qd),u.qdd.push(p),u.tau.push(M),u.work.push(m.y[2*d.dof])}}catch(g){let x=g instanceof yr||g.name==="SingularMassMatrix";if(!(g instanceof so)&&!x)throw g;u.ended={t:m.t,reason:x?Bx(e,g.joint):g.message}}return u}var Vx=100,[Gx,Hx]=[201,2001];function Pl(n){return Math.min(Math.max(Math.round(Vx*n)+1,Gx),Hx)}function Yp(n,e){let t=Pl(e.duration),{base:i}=e,s=i?eo.map(()=>0):[],r=h=>{let{q:d,...u}=Lp(e,h),[m,g]=[u.qd,u.qdd].map(x=>[...s,...x]);return{base:i,q:d,qd:m,qdd:g,tau:n.inverse_dynamics(i,d,m,g)}},o=Array.from({length:t},(h,d)=>e.duration*d/(t-1)),a=o.map(r),l=h=>a.map(d=>d[h]),c={t:o,base:l("base"),q:l("q"),qd:l("qd"),qdd:l("qdd"),tau:l("tau")};return Il(n,{...c,at:r,ended:null,duration:e.duration},e)}function $p(n,e){let t=qp({...e,equations:n,samples:Pl(e.duration)});t.t.length===0&&Wx(t,e);let i=t.t.length>0?t.t[t.t.length-1]:0,s=Il(n,{...t,duration:i,at:h=>Nu(t,h)},e),{total:r,kinetic:o,potential:a}=s,l=r.map((h,d)=>Math.abs(h-r[0]-t.work[d])),c=h=>Math.max(...h)-Math.min(...h);return s.drift=Math.max(0,...l),s.energyScale=Math.max(c(o),c(a),c(t.work),0),s}function Wx(n,{base:e,q:t,qd:i}){let s=i.map(()=>NaN);for(let[r,o]of Object.entries({t:0,base:e,q:t,qd:i,qdd:s,tau:s,work:0}))n[r].push(o)}function Il(n,e,{key:t}){let{base:i,q:s,qd:r}=e,o=s.map((h,d)=>n.kinetic_energy(h,r[d])),a=s.map((h,d)=>n.potential_energy(i[d],h)),l=o.map((h,d)=>h+a[d]),c=s.map((h,d)=>n[t](i[d],h).slice(0,3).map(u=>u[3]));return{...e,kinetic:o,potential:a,total:l,tip:c}}function Nu(n,e){let{t}=n,i=t.length-1,s=m=>Object.fromEntries(["base","q","qd","qdd","tau"].map(g=>[g,n[g][m]]));if(i<1)return s(0);let r=t[1]-t[0],o=Math.min(Math.max(Math.floor(e/r),0),i-1),a=Math.min(Math.max((e-t[o])/r,0),1);if(a===0||a===1)return s(o+a);let[l,c]=[s(o),s(o+1)],h=l.qd.length-l.q.length,d=(m,g,x)=>l[m].map((f,p)=>f+bu(c[m][p]-f,r*l[g][x+p],r*c[g][x+p],a)),u=m=>m[o].map((g,x)=>g+a*(m[o+1][x]-g));return{base:l.base&&yp([l.base,c.base],[l.qd,c.qd],r,a),q:d("q","qd",h),qd:d("qd","qdd",0),qdd:u(n.qdd),tau:u(n.tau)}}function Zp(n,e){let t=["q","qd","qdd","tau"],[i]=n.base,s=h=>e.slice(e.length-n[h][0].length),r=t.flatMap(h=>s(h).map(d=>`${h}_${d}`)),a=[...[1,2,3].flatMap(h=>[1,2,3].map(d=>`r${h}${d}`)),"x","y","z"].map(h=>`base.${h}`),l=["t",...i?a:[],...r,"kinetic","potential","x","y","z"],c=n.t.map((h,d)=>[h,...n.base[d]??[],...t.flatMap(u=>n[u][d]),n.kinetic[d],n.potential[d],...n.tip[d]]);return[l,...c].map(h=>h.join(",")).join(`
`)+`
`}var Xx=.3;function qx(n,e,t){let{columns:i}=Tl(n,e),s=n.hasRotation?6:3,r=(a,l)=>a.slice(0,s).reduce((c,h,d)=>c+h*l[d],0),o=i.map((a,l)=>i.map((c,h)=>r(a,c)+(l===h?1e-10:0)));return Vs(o,i.map(a=>r(a,t)),e.map((a,l)=>l))}function Yx(n,e){let t=n.length-1,i=(s,r)=>n[0].map((o,a)=>r.reduce((l,[c,h])=>l+h*n[s+c][a],0)/(2*e));return n.map((s,r)=>r===0?i(0,[[0,-3],[1,4],[2,-1]]):r===t?i(t,[[0,3],[-1,-4],[-2,1]]):i(r,[[1,1],[-1,-1]]))}function jp(n,e,t){let{from:i,duration:s,profile:r,base:o}=t,a=Pl(s),l=s/(a-1),{frame:c}=Tl(e,i),h=Pt(e.target.o,c.o),d=Pu(c,e.target),u=e.hasRotation?2*Math.asin(Math.min(1,Gt(d)/2)):0,m=On(d),g={t:[],base:[],q:[],qd:[],ended:null},x=i;for(let f=0;f<a;f++){let[p,M]=Au[r](f/(a-1)),C=v=>gr(v,m,u*p),y={x:C(c.x),y:C(c.y),z:C(c.z),o:Oe(c.o,be(h,p))},T={...e,target:y},b=Al(T,x),_=$x(e,x,b);if(_&&f>0){g.ended={t:f*l,reason:_};break}x=b.q,g.t.push(f*l),g.base.push(o),g.q.push(x),g.qd.push(qx(e,x,[...be(h,M/s),...be(m,u*M/s)]))}return Zx(n,g,l,t)}function $x({size:n,joints:e},t,i){return i.isReached?t.some((r,o)=>Math.abs(i.q[o]-r)>Xx*(e[o].type==="revolute"?1:n))?"the line passes a singular pose, where the joints would have to jump":null:"the line leaves what the arm reaches within its limits, or meets a singular pose"}function Zx(n,e,t,{base:i,key:s}){let r=i?[0,0,0,0,0,0]:[],a=e.t.length>2?Yx(e.qd,t):e.qd.map(d=>d.map(()=>0)),l=d=>d.map(u=>[...r,...u]),c={...e,qd:l(e.qd),qdd:l(a)};c.tau=c.q.map((d,u)=>n.inverse_dynamics(i,d,c.qd[u],c.qdd[u]));let h=c.t[c.t.length-1];return Il(n,{...c,duration:h,at:d=>Nu(c,d)},{key:s})}var Qp=n=>typeof n=="number"?[n]:n&&typeof n=="object"?Object.values(n).flatMap(Qp):[];function Jp([n,e,t,i,s,r],o){return[[[n,e,t],o],[[n*e-i*i,e*t-s*s,n*t-r*r],o**2],[[n*(e*t-s*s)-i*(i*t-s*r)+r*(i*s-e*r)],o**3]].every(([l,c])=>l.every(h=>h>=-1e-9*c))}function jx([n,e,t,i,s,r]){let o=Math.max(...[n,e,t,i,s,r].map(Math.abs));if([n,e,t].filter(c=>c!==0).length<2&&Math.min(n,e,t)>=0&&i===0&&s===0&&r===0)return null;let a=(n+e+t)/2;return Jp([n,e,t,i,s,r],o)&&Jp([a-n,a-e,a-t,-i,-s,-r],o)?null:"no body has this inertia tensor"}function Kp(n){if(Qp(n).some(t=>!Number.isFinite(t)))return"division by zero, or a number that is too large";let e=[[n.mass,"a mass"],[n.motorInertia,"a motor's inertia"],[n.viscous,"a friction coefficient"],[Math.min(...n.coulomb??[]),"a friction torque or force"],[n.stribeck?.friction,"a friction torque or force"],[n.spring?.stiffness,"a spring's stiffness"]].find(([t])=>t<0);return e?`${e[1]} cannot be negative`:n.motorInertia>0&&n.gearRatio===0?"a gear ratio of zero: a motor with inertia turns with its joint":n.stribeck&&!(n.stribeck.velocity>0)?"a Stribeck velocity is above zero":jx(n.inertia)}function em(n,e){let t=({rows:s,tool:r,base:o,floating:a,gravity:l})=>[...s,r,a,o&&{inertia:[0,0,0,0,0,0],base:o},{inertia:[0,0,0,0,0,0],gravity:l}],i=t(e);for(let[s,r]of t(n).entries()){let o=r&&Kp(r);if(o&&o!==Kp(i[s]))return r.name?`\`${r.name}\`: ${o}`:o}return null}function tm(){let n=new Map;return{on(e,t){for(let i of e.split(" "))n.set(i,[...n.get(i)??[],t])},tell(e){(n.get(e)??[]).forEach(t=>t())}}}var Jx=30;function Kx(n,e){return n.limits?n.limits:n.type==="revolute"?[-Math.PI,Math.PI]:[-e,e]}function Qx([n,e]){return n<=0&&e>=0?0:(n+e)/2}var nm=[0,0,0,.1,1.5,.3],im=[60,40,-50,30,70,-40];function ey(n,{type:e,joint:t},[i,s]){let r=im[t%im.length],o=e==="revolute"?r*Math.PI/180:(s-i)*r/240,[a,l]=[n+o,n-o],c=h=>h>=i&&h<=s;return c(a)?a:c(l)?l:o>0?s:i}function sm(n,e,t){let{on:i,tell:s}=tm(),r=Object.fromEntries(t.fields.map(({name:y,value:T})=>[y,T])),o=n(r),a=o.floating!==null,l=Pp(e,r,a),c=o.rows.filter(y=>y.type==="prismatic"&&y.joint!==null).reduce((y,T)=>y+(T.limits?Math.max(...T.limits.map(Math.abs)):0),0),h=Rp(o,c),d=o.rows.filter(y=>y.joint!==null),u=d.map(y=>Kx(y,h)),m=[...a?eo:[],...d],g=m.map(()=>0),x=t.from??u.map(Qx),f={mode:"motion",pose:[...t.pose??[0,0,0,0,0,0]],q:[...x],qd:[...t.velocity??(a?[...nm,...g.slice(nm.length)]:g)],qdd:[...g],end:t.to??x.map((y,T)=>ey(y,d[T],u[T])),torque:[...g],target:null,hasRotation:!0,path:"joints",reached:{found:[],chosen:0,missing:null},isDragged:!1,profile:"cycloidal",law:"none",hasFriction:!0,duration:t.duration,t:0,isPlaying:!1,isRepeated:!1,speed:1,selected:o.rows.indexOf(d[0]),tip:0,show:{parameters:"selected",frames:!1,axes:!1,masses:!1,trace:!0,names:!1,isFollowed:!0}},p={on:i,tell:s,state:f,first:t,fields:r,equations:l,table:o,size:h,joints:d,freedoms:m,ofBase:m.length-d.length,ranges:u,trajectory:null,units:gu(!0),now(){if(f.mode==="pose"){let{q:y,qd:T,qdd:b}=f,_=p.start();return{base:_,q:y,qd:T,qdd:b,tau:l.inverse_dynamics(_,y,T,b)}}return p.trajectory.at(f.t)},start:()=>a?_p(f.pose):null,tip:()=>o.tips[f.tip],evaluated:()=>Ip(l,p.now(),p.tip()),frames(){let{base:y,q:T}=p.now();return Ii(p.table,T,y)},setTime(y){let T=p.trajectory?.duration??0;f.t=Math.min(Math.max(y,0),T),s("time")},play(y){p.trajectory&&(f.isPlaying=y,y&&f.t>=p.trajectory.duration&&p.setTime(0),s("play"))},problem(){let{hasRotation:y,tip:T,target:b}=f,[_,v,D,...P]=b,I=es(ks,{xyz:[_,v,D],rpy:P}),L=d.map(O=>O.limits);return{table:p.table,base:p.start(),tip:T,target:I,hasRotation:y,limits:L,ranges:u,joints:d,size:h}},seek(y=!1){let T=p.problem();if(f.isDragged=y,y){let{q:b,isReached:_,...v}=Al(T,f.end);f.end=b,f.reached={found:_?[b]:[],chosen:0,missing:_?null:v}}else{let{found:b,nearest:_}=Vp(T,f.end);f.reached={found:b,chosen:0,missing:_},f.end=b[0]??_.q}f.isPlaying=!1,p.recompute(),p.setTime(p.trajectory.duration),s("reached"),s("play")},choose(y,T=!1){let{found:b}=f.reached;T?b[y].forEach((_,v)=>f.q[v]=_):[f.end,f.reached.chosen]=[[...b[y]],y],s("reached"),p.changed()},placeTarget(){let{tips:y}=Ii(p.table,f.end,p.start()),{x:T,y:b,z:_,o:v}=y[f.tip];f.hasRotation=Fp(p.table,f.tip)>=6,f.target=[...v,...Qr([0,1,2].map(D=>[T[D],b[D],_[D]]))]},setMode(y){f.mode=y,y==="reach"&&(p.placeTarget(),p.seek()),f.isPlaying=!1,f.t=0,y!=="reach"&&p.recompute(),s("mode"),s("time"),s("play")},changed(){f.isPlaying=!1,f.t=0,s("play"),p.ask()},setFields(y){let T=n({...r,...y}),b=em(T,o);return b||(Object.assign(r,y),p.table=T,s("fields"),f.mode==="reach"?p.seek():p.changed(),null)},setUnits(y){p.units=gu(y),s("units")},select(y){f.selected=y,s("selection")},setTip(y){f.tip=y,f.mode==="reach"?(p.placeTarget(),p.seek()):p.recompute(),s("tip")},setShown(y){Object.assign(f.show,y),s("show")},recompute(){let y=performance.now(),{q:T,qd:b,end:_,torque:v,profile:D,law:P,hasFriction:I,duration:L}=f,{table:O}=p,R=p.start(),{key:U}=p.tip(),k=f.mode==="reach";p.trajectory=k&&f.path==="line"&&!f.isDragged?jp(l,p.problem(),{base:R,from:[...T],duration:L,profile:D,key:U}):f.mode==="motion"||k?Yp(l,{base:R,from:[...T],to:[..._],duration:L,profile:D,key:U}):f.mode==="free"?$p(l,{table:O,law:P,hasFriction:I,duration:L,key:U,base:R,q:[...T],qd:[...b],torque:[...v]}):null,M=performance.now()-y,C=void 0,s("trajectory"),s("time")},isStale:()=>C!==void 0,ask(){clearTimeout(C),C=setTimeout(p.recompute,M>Jx?160:0)}},[M,C]=[0,void 0];return p.recompute(),p}var ty="uplot",ny="u-hz",iy="u-vt",sy="u-title",ry="u-wrap",oy="u-under",ay="u-over",ly="u-axis",Mr="u-off",cy="u-select",hy="u-cursor-x",uy="u-cursor-y",dy="u-cursor-pt",fy="u-legend",py="u-live",my="u-inline",gy="u-series",_y="u-marker",rm="u-label",xy="u-value",ha="width",ua="height";var om="bottom",ro="left",Uu="right",Ku="#000",am=Ku+"0",Fu="mousemove",lm="mousedown",Ou="mouseup",cm="mouseenter",hm="mouseleave",um="dblclick",yy="resize",vy="scroll",dm="change",Fl="dppxchange",Qu="--",fo=typeof window<"u",Gu=fo?document:null,ao=fo?window:null,Sy=fo?navigator:null,At,Ll;function Hu(){let n=devicePixelRatio;At!=n&&(At=n,Ll&&Xu(dm,Ll,Hu),Ll=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),br(dm,Ll,Hu),ao.dispatchEvent(new CustomEvent(Fl)))}function ui(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Wu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function $t(n,e,t){n.style[e]=t+"px"}function Li(n,e,t,i){let s=Gu.createElement(n);return e!=null&&ui(s,e),t?.insertBefore(s,i),s}function Mi(n,e){return Li("div",n,e)}var fm=new WeakMap;function ts(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=fm.get(n);r!=o&&(n.style.transform=r,fm.set(n,r),e<0||t<0||e>i||t>s?ui(n,Mr):Wu(n,Mr))}var pm=new WeakMap;function mm(n,e,t){let i=e+t,s=pm.get(n);i!=s&&(pm.set(n,i),n.style.background=e,n.style.borderColor=t)}var gm=new WeakMap;function _m(n,e,t,i){let s=e+""+t,r=gm.get(n);s!=r&&(gm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var ed={passive:!0},My={...ed,capture:!0};function br(n,e,t,i){e.addEventListener(n,t,i?My:ed)}function Xu(n,e,t,i){e.removeEventListener(n,t,ed)}fo&&Hu();function Di(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:di((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Xm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var qm=n=>n!=null,Ym=n=>n!=null&&n>0,zl=Xm(qm),by=Xm(Ym);function wy(n,e,t,i=0,s=!1){let r=s?by:zl,o=s?Ym:qm;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??kt,l??-kt]}function kl(n,e,t,i){let s=vm(n),r=vm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?xs:$m,a=s==1?di:bi,l=r==1?bi:di,c=a(o(Sn(n))),h=l(o(Sn(e))),d=lo(t,c),u=lo(t,h);return t==10&&(c<0&&(d=Vt(d,-c)),h<0&&(u=Vt(u,-h))),i||t==2?(n=d*s,e=u*r):(n=Km(n,d),e=Vl(e,u)),[n,e]}function td(n,e,t,i){let s=kl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var nd=.1,xm={mode:3,pad:nd},fa={pad:0,soft:null,mode:0},Ey={min:fa,max:fa};function Ol(n,e,t,i){return Gl(t)?ym(n,e,t):(fa.pad=t,fa.soft=i?0:null,fa.mode=i?3:0,ym(n,e,Ey))}function Et(n,e){return n??e}function Ty(n,e,t){for(e=Et(e,0),t=Et(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function ym(n,e,t){let i=t.min,s=t.max,r=Et(i.pad,0),o=Et(s.pad,0),a=Et(i.hard,-kt),l=Et(s.hard,kt),c=Et(i.soft,kt),h=Et(s.soft,-kt),d=Et(i.mode,0),u=Et(s.mode,0),m=e-n,g=xs(m),x=Yn(Sn(n),Sn(e)),f=xs(x),p=Sn(f-g);(m<1e-24||p>10)&&(m=0,(n==0||e==0)&&(m=1e-24,d==2&&c!=kt&&(r=0),u==2&&h!=-kt&&(o=0)));let M=m||x||1e3,C=xs(M),y=lo(10,di(C)),T=M*(m==0?n==0?.1:1:r),b=Vt(Km(n-T,y/10),24),_=n>=c&&(d==1||d==3&&b<=c||d==2&&b>=c)?c:kt,v=Yn(a,b<_&&n>=_?_:Ni(_,b)),D=M*(m==0?e==0?.1:1:o),P=Vt(Vl(e+D,y/10),24),I=e<=h&&(u==1||u==3&&P>=h||u==2&&P<=h)?h:-kt,L=Ni(l,P>I&&e<=I?I:Yn(I,P));return v==L&&v==0&&(L=100),[v,L]}var Ay=new Intl.NumberFormat(fo?Sy.language:"en-US"),id=n=>Ay.format(n),fi=Math,Ul=fi.PI,Sn=fi.abs,di=fi.floor,vn=fi.round,bi=fi.ceil,Ni=fi.min,Yn=fi.max,lo=fi.pow,vm=fi.sign,xs=fi.log10,$m=fi.log2,Ry=(n,e=1)=>fi.sinh(n)*e,Bu=(n,e=1)=>fi.asinh(n/e),kt=1/0;function Sm(n){return(xs((n^n>>31)-(n>>31))|0)+1}function qu(n,e,t){return Ni(Yn(n,e),t)}function Zm(n){return typeof n=="function"}function vt(n){return Zm(n)?n:()=>n}var Cy=()=>{},jm=n=>n,Jm=(n,e)=>e,Py=n=>null,Mm=n=>!0,bm=(n,e)=>n==e,Iy=/\.\d*?(?=9{6,}|0{6,})/gm,wr=n=>{if(eg(n)||Hs.has(n))return n;let e=`${n}`,t=e.match(Iy);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${wr(s)}e${r}`}return Vt(n,i)};function vr(n,e){return wr(Vt(wr(n/e))*e)}function Vl(n,e){return wr(bi(wr(n/e))*e)}function Km(n,e){return wr(di(wr(n/e))*e)}function Vt(n,e=0){if(eg(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return vn(i)/t}var Hs=new Map;function Qm(n){return((""+n).split(".")[1]||"").length}function ma(n,e,t,i){let s=[],r=i.map(Qm);for(let o=e;o<t;o++){let a=Sn(o),l=Vt(lo(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=n==10?h:Vt(h,d);s.push(u),Hs.set(u,d)}}return s}var pa={},sd=[],co=[null,null],Gs=Array.isArray,eg=Number.isInteger,Ly=n=>n===void 0;function wm(n){return typeof n=="string"}function Gl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Dy(n){return n!=null&&typeof n=="object"}var Ny=Object.getPrototypeOf(Uint8Array),tg="__proto__";function ho(n,e=Gl){let t;if(Gs(n)){let i=n.find(s=>s!=null);if(Gs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=ho(n[s],e)}else t=n.slice()}else if(n instanceof Ny)t=n.slice();else if(e(n)){t={};for(let i in n)i!=tg&&(t[i]=ho(n[i],e))}else t=n;return t}function mn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=tg&&(Gl(n[s])?mn(n[s],ho(i[s])):n[s]=ho(i[s]))}return n}var Uy=0,Fy=1,Oy=2;function By(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function zy(n,e){if(Gy(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Hy(o[0])||(o=Vy(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=e?e[o][c]:Fy,m=[];for(let g=0;g<h.length;g++){let x=h[g],f=r.get(l[g]);x===null?u!=Uy&&(d[f]=x,u==Oy&&m.push(f)):d[f]=x}By(d,m,s),i.push(d)}}return i}var ky=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Vy(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Gy(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Hy(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Yn(1,di((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ng=["January","February","March","April","May","June","July","August","September","October","November","December"],ig=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function sg(n){return n.slice(0,3)}var Wy=ig.map(sg),Xy=ng.map(sg),qy={MMMM:ng,MMM:Xy,WWWW:ig,WWW:Wy};function ca(n){return(n<10?"0":"")+n}function Yy(n){return(n<10?"00":n<100?"0":"")+n}var $y={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ca(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ca(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ca(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ca(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ca(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Yy(n.getMilliseconds())};function rd(n,e){e=e||qy;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?$y[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Zy=new Intl.DateTimeFormat().resolvedOptions().timeZone;function jy(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Zy?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var rg=n=>n%1==0,Bl=[1,2,2.5,5],Jy=ma(10,-32,0,Bl),og=ma(10,0,32,Bl),Ky=og.filter(rg),Sr=Jy.concat(og),od=`
`,ag="{YYYY}",Em=od+ag,lg="{M}/{D}",da=od+lg,Dl=da+"/{YY}",cg="{aa}",Qy="{h}:{mm}",oo=Qy+cg,Tm=od+oo,Am=":{ss}",It=null;function hg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?ma(10,0,3,Bl).filter(rg):ma(10,-3,0,Bl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,ag,It,It,It,It,It,It,1],[s*28,"{MMM}",Em,It,It,It,It,It,1],[s,lg,Em,It,It,It,It,It,1],[i,"{h}"+cg,Dl,It,da,It,It,It,1],[t,oo,Dl,It,da,It,It,It,1],[e,Am,Dl+" "+oo,It,da+" "+oo,It,Tm,It,1],[n,Am+".{fff}",Dl+" "+oo,It,da+" "+oo,It,Tm,It,1]];function h(d){return(u,m,g,x,f,p)=>{let M=[],C=f>=o,y=f>=r&&f<o,T=d(g),b=Vt(T*n,3),_=zu(T.getFullYear(),C?0:T.getMonth(),y||C?1:T.getDate()),v=Vt(_*n,3);if(y||C){let D=y?f/r:0,P=C?f/o:0,I=b==v?b:Vt(zu(_.getFullYear()+P,_.getMonth()+D,1)*n,3),L=new Date(vn(I/n)),O=L.getFullYear(),R=L.getMonth();for(let U=0;I<=x;U++){let k=zu(O+P*U,R+D*U,1),z=k-d(Vt(k*n,3));I=Vt((+k+z)*n,3),I<=x&&M.push(I)}}else{let D=f>=s?s:f,P=di(g)-di(b),I=v+P+Vl(b-v,D);M.push(I);let L=d(I),O=L.getHours()+L.getMinutes()/t+L.getSeconds()/i,R=f/i,U=u.axes[m]._space,k=p/U;for(;I=Vt(I+f,n==1?0:3),!(I>x);)if(R>1){let z=di(Vt(O+R,6))%24,Z=d(I).getHours()-z;Z>1&&(Z=-1),I-=Z*i,O=(O+R)%24;let te=M[M.length-1];Vt((I-te)/f,3)*k>=.7&&M.push(I)}else M.push(I)}return M}}return[l,c,h]}var[ev,tv,nv]=hg(1),[iv,sv,rv]=hg(.001);ma(2,-53,53,[1]);function Rm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Cm(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,d,u,m;return i.map(g=>{let x=n(g),f=x.getFullYear(),p=x.getMonth(),M=x.getDate(),C=x.getHours(),y=x.getMinutes(),T=x.getSeconds(),b=f!=l&&a[2]||p!=c&&a[3]||M!=h&&a[4]||C!=d&&a[5]||y!=u&&a[6]||T!=m&&a[7]||a[1];return l=f,c=p,h=M,d=C,u=y,m=T,b(x)})}}function ov(n,e){let t=rd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function zu(n,e,t){return new Date(n,e,t)}function Pm(n,e){return e(n)}var av="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Im(n,e){return(t,i,s,r)=>r==null?Qu:e(n(i))}function lv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function cv(n,e){return n.series[e].fill(n,e)}var hv={show:!0,live:!0,isolate:!1,mount:Cy,markers:{show:!0,width:2,stroke:lv,fill:cv,dash:"solid"},idx:null,idxs:null,values:[]};function uv(n,e){let t=n.cursor.points,i=Mi(),s=t.size(n,e);$t(i,ha,s),$t(i,ua,s);let r=s/-2;$t(i,"marginLeft",r),$t(i,"marginTop",r);let o=t.width(n,e,s);return o&&$t(i,"borderWidth",o),i}function dv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function fv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function pv(n,e){return n.series[e].points.size}var ku=[0,0];function mv(n,e,t){return ku[0]=e,ku[1]=t,ku}function Nl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Vu(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var gv={show:!0,x:!0,y:!0,lock:!1,move:mv,points:{one:!1,show:uv,size:pv,width:0,stroke:fv,fill:dv},bind:{mousedown:Nl,mouseup:Nl,click:Nl,dblclick:Nl,mousemove:Vu,mouseleave:Vu,mouseenter:Vu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ug={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ad=mn({},ug,{filter:Jm}),dg=mn({},ad,{size:10}),fg=mn({},ug,{show:!1}),ld='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',pg="bold "+ld,mg=1.5,Lm={show:!0,scale:"x",stroke:Ku,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:pg,side:2,grid:ad,ticks:dg,border:fg,font:ld,lineGap:mg,rotate:0},_v="Value",xv="Time",Dm={show:!0,scale:"x",auto:!1,sorted:1,min:kt,max:-kt,idxs:[]};function yv(n,e,t,i,s){return e.map(r=>r==null?"":id(r))}function vv(n,e,t,i,s,r,o){let a=[],l=Hs.get(s)||0;t=o?t:Vt(Vl(t,s),l);for(let c=t;c<=i;c=Vt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Yu(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?xs:$m,h=di(c(t));s=lo(l,h),l==10&&(s=Sr[Di(s,Sr)]);let d=t,u=s*l;l==10&&(u=Sr[Di(u,Sr)]);do a.push(d),d=d+s,l==10&&!Hs.has(d)&&(d=Vt(d,Hs.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Sr[Di(u,Sr)]));while(d<=i);return a}function Sv(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Yu(n,e,Yn(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?Yu(n,e,Yn(l,-i),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var gg=/./,Mv=/[12357]/,bv=/[125]/,Nm=/1/,$u=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function wv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?gg:l(7,o)-h>=c?Mv:l(5,o)-h>=c?bv:Nm;if(d==Nm){let u=Sn(l(1,o)-h);if(u<c)return $u(e.slice().reverse(),a.distr,d,bi(c/u)).reverse()}return $u(e,a.distr,d,1)}function Ev(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?$u(e.slice().reverse(),3,gg,bi(a/c)).reverse():e}function Tv(n,e,t,i){return i==null?Qu:e==null?"":id(e)}var Um={show:!0,scale:"y",stroke:Ku,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:pg,side:3,grid:ad,ticks:dg,border:fg,font:ld,lineGap:mg,rotate:0};function Av(n,e){let t=3+(n||1)*2;return Vt(t*e,3)}function Rv(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Sn(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var Fm={scale:null,auto:!0,sorted:0,min:kt,max:-kt},_g=(n,e,t,i,s)=>s,Om={show:!0,auto:!0,sorted:0,gaps:_g,alpha:1,facets:[mn({},Fm,{scale:"x"}),mn({},Fm,{scale:"y"})]},Bm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:_g,alpha:1,points:{show:Rv,filter:null},values:null,min:kt,max:-kt,idxs:[],path:null,clip:null};function Cv(n,e,t,i,s){return t/10}var xg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Pv=mn({},xg,{time:!1,ori:1}),zm={};function yg(n,e){let t=zm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(zm[n]=t)),t}var uo=1,Zu=2;function Er(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,m=a.top,g=a.width,x=a.height,f=n.valToPosH,p=n.valToPosV;return h.ori==0?t(s,l,c,h,d,f,p,u,m,g,x,Wl,po,ql,Sg,bg):t(s,l,c,h,d,p,f,m,u,x,g,Xl,mo,ud,Mg,wg)}function cd(n,e){let t=0,i=0,s=Et(n.bands,sd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Iv(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ys(n,e,t,i,s,r){return Er(n,e,(o,a,l,c,h,d,u,m,g,x,f)=>{let p=o.pxRound,M=c.dir*(c.ori==0?1:-1),C=c.ori==0?po:mo,y,T;M==1?(y=t,T=i):(y=i,T=t);let b=p(d(a[y],c,x,m)),_=p(u(l[y],h,f,g)),v=p(d(a[T],c,x,m)),D=p(u(r==1?h.max:h.min,h,f,g)),P=new Path2D(s);return C(P,v,D),C(P,b,D),C(P,b,_),P})}function Hl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?ql:ud,l=t;for(let d=0;d<n.length;d++){let u=n[d];if(u[1]>u[0]){let m=u[0]-l;m>0&&a(o,l,i,m,i+r),l=u[1]}}let c=t+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function Lv(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function hd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=i&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let m=r(n[d]),g=u==d?m:r(n[u]),x=d-s;m=o<=0&&x>=0&&x<l?r(n[x]):m;let p=u+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=m&&a.push([m,g])}return a}function km(n){return n==0?jm:n==1?vn:e=>vr(e,n)}function vg(n){let e=n==0?Wl:Xl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Ni(c,a/2,l/2),h=Ni(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Wl=(n,e,t)=>{n.moveTo(e,t)},Xl=(n,e,t)=>{n.moveTo(t,e)},po=(n,e,t)=>{n.lineTo(e,t)},mo=(n,e,t)=>{n.lineTo(t,e)},ql=vg(0),ud=vg(1),Sg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Mg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},bg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},wg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Eg(n){return(e,t,i,s,r)=>Er(e,t,(o,a,l,c,h,d,u,m,g,x,f)=>{let{pxRound:p,points:M}=o,C,y;c.ori==0?(C=Wl,y=Sg):(C=Xl,y=Mg);let T=Vt(M.width*At,3),b=(M.size-M.width)/2*At,_=Vt(b*2,3),v=new Path2D,D=new Path2D,{left:P,top:I,width:L,height:O}=e.bbox;ql(D,P-_,I-_,L+_*2,O+_*2);let R=U=>{if(l[U]!=null){let k=p(d(a[U],c,x,m)),z=p(u(l[U],h,f,g));C(v,k+b,z),y(v,k,z,b,0,Ul*2)}};if(r)r.forEach(R);else for(let U=i;U<=s;U++)R(U);return{stroke:T>0?v:null,fill:v,clip:D,flags:uo|Zu}})}function Tg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Dv=Tg(po),Nv=Tg(mo);function Ag(n){let e=Et(n?.alignGaps,0);return(t,i,s,r)=>Er(t,i,(o,a,l,c,h,d,u,m,g,x,f)=>{[s,r]=zl(l,s,r);let p=o.pxRound,M=O=>p(d(O,c,x,m)),C=O=>p(u(O,h,f,g)),y,T;c.ori==0?(y=po,T=Dv):(y=mo,T=Nv);let b=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:uo},v=_.stroke,D=!1;if(r-s>=x*4){let O=ce=>t.posToVal(ce,c.key,!0),R=null,U=null,k,z,$,X=M(a[b==1?s:r]),Z=M(a[s]),te=M(a[r]),oe=O(b==1?Z+1:te-1);for(let ce=b==1?s:r;ce>=s&&ce<=r;ce+=b){let Q=a[ce],_e=(b==1?Q<oe:Q>oe)?X:M(Q),ae=l[ce];_e==X?ae!=null?(z=ae,R==null?(y(v,_e,C(z)),k=R=U=z):z<R?R=z:z>U&&(U=z)):ae===null&&(D=!0):(R!=null&&T(v,X,C(R),C(U),C(k),C(z)),ae!=null?(z=ae,y(v,_e,C(z)),R=U=k=z):(R=U=null,ae===null&&(D=!0)),X=_e,oe=O(X+b))}R!=null&&R!=U&&$!=X&&T(v,X,C(R),C(U),C(k),C(z))}else for(let O=b==1?s:r;O>=s&&O<=r;O+=b){let R=l[O];R===null?D=!0:R!=null&&y(v,M(a[O]),C(R))}let[I,L]=cd(t,i);if(o.fill!=null||I!=0){let O=_.fill=new Path2D(v),R=o.fillTo(t,i,o.min,o.max,I),U=C(R),k=M(a[s]),z=M(a[r]);b==-1&&([z,k]=[k,z]),y(O,z,U),y(O,k,U)}if(!o.spanGaps){let O=[];D&&O.push(...hd(a,l,s,r,b,M,e)),_.gaps=O=o.gaps(t,i,s,r,O),_.clip=Hl(O,c.ori,m,g,x,f)}return L!=0&&(_.band=L==2?[ys(t,i,s,r,v,-1),ys(t,i,s,r,v,1)]:ys(t,i,s,r,v,L)),_})}function Uv(n){let e=Et(n.align,1),t=Et(n.ascDesc,!1),i=Et(n.alignGaps,0),s=Et(n.extend,!1);return(r,o,a,l)=>Er(r,o,(c,h,d,u,m,g,x,f,p,M,C)=>{[a,l]=zl(d,a,l);let y=c.pxRound,{left:T,width:b}=r.bbox,_=Z=>y(g(Z,u,M,f)),v=Z=>y(x(Z,m,C,p)),D=u.ori==0?po:mo,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:uo},I=P.stroke,L=u.dir*(u.ori==0?1:-1),O=v(d[L==1?a:l]),R=_(h[L==1?a:l]),U=R,k=R;s&&e==-1&&(k=T,D(I,k,O)),D(I,R,O);for(let Z=L==1?a:l;Z>=a&&Z<=l;Z+=L){let te=d[Z];if(te==null)continue;let oe=_(h[Z]),ce=v(te);e==1?D(I,oe,O):D(I,U,ce),D(I,oe,ce),O=ce,U=oe}let z=U;s&&e==1&&(z=T+b,D(I,z,O));let[$,X]=cd(r,o);if(c.fill!=null||$!=0){let Z=P.fill=new Path2D(I),te=c.fillTo(r,o,c.min,c.max,$),oe=v(te);D(Z,z,oe),D(Z,k,oe)}if(!c.spanGaps){let Z=[];Z.push(...hd(h,d,a,l,L,_,i));let te=c.width*At/2,oe=t||e==1?te:-te,ce=t||e==-1?-te:te;Z.forEach(Q=>{Q[0]+=oe,Q[1]+=ce}),P.gaps=Z=c.gaps(r,o,a,l,Z),P.clip=Hl(Z,u.ori,f,p,M,C)}return X!=0&&(P.band=X==2?[ys(r,o,a,l,I,-1),ys(r,o,a,l,I,1)]:ys(r,o,a,l,I,X)),P})}function Vm(n,e,t,i,s,r,o=kt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=Sn(n[l]-n[a]);h<c&&(c=h,o=Sn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Fv(n){n=n||pa;let e=Et(n.size,[.6,kt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=Et(e[1],kt),l=Et(e[2],1),c=Et(n.disp,pa),h=Et(n.each,m=>{}),{fill:d,stroke:u}=c;return(m,g,x,f)=>Er(m,g,(p,M,C,y,T,b,_,v,D,P,I)=>{let L=p.pxRound,O=t,R=i*At,U=a*At,k=l*At,z,$;y.ori==0?[z,$]=r(m,g):[$,z]=r(m,g);let X=y.dir*(y.ori==0?1:-1),Z=y.ori==0?ql:ud,te=y.ori==0?h:(Pe,Je,lt,Ee,zt,We,Ze)=>{h(Pe,Je,lt,zt,Ee,Ze,We)},oe=Et(m.bands,sd).find(Pe=>Pe.series[0]==g),ce=oe!=null?oe.dir:0,Q=p.fillTo(m,g,p.min,p.max,ce),me=L(_(Q,T,I,D)),_e,ae,de,Ne=P,Ye=L(p.width*At),Be=!1,st=null,at=null,$e=null,pt=null;d!=null&&(Ye==0||u!=null)&&(Be=!0,st=d.values(m,g,x,f),at=new Map,new Set(st).forEach(Pe=>{Pe!=null&&at.set(Pe,new Path2D)}),Ye>0&&($e=u.values(m,g,x,f),pt=new Map,new Set($e).forEach(Pe=>{Pe!=null&&pt.set(Pe,new Path2D)})));let{x0:Mt,size:jt}=c;if(Mt!=null&&jt!=null){O=1,M=Mt.values(m,g,x,f),Mt.unit==2&&(M=M.map(lt=>m.posToVal(v+lt*P,y.key,!0)));let Pe=jt.values(m,g,x,f);jt.unit==2?ae=Pe[0]*P:ae=b(Pe[0],y,P,v)-b(0,y,P,v),Ne=Vm(M,C,b,y,P,v,Ne),de=Ne-ae+R}else Ne=Vm(M,C,b,y,P,v,Ne),de=Ne*o+R,ae=Ne-de;de<1&&(de=0),Ye>=ae/2&&(Ye=0),de<5&&(L=jm);let Ct=de>0,rn=Ne-de-(Ct?Ye:0);ae=L(qu(rn,k,U)),_e=(O==0?ae/2:O==X?0:ae)-O*X*((O==0?R/2:0)+(Ct?Ye/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=Be?null:new Path2D,Qt=null;if(oe!=null)Qt=m.data[oe.series[1]];else{let{y0:Pe,y1:Je}=c;Pe!=null&&Je!=null&&(C=Je.values(m,g,x,f),Qt=Pe.values(m,g,x,f))}let ln=z*ae,G=$*ae;for(let Pe=X==1?x:f;Pe>=x&&Pe<=f;Pe+=X){let Je=C[Pe];if(Je==null)continue;if(Qt!=null){let j=Qt[Pe]??0;if(Je-j==0)continue;me=_(j,T,I,D)}let lt=y.distr!=2||c!=null?M[Pe]:Pe,Ee=b(lt,y,P,v),zt=_(Et(Je,Q),T,I,D),We=L(Ee-_e),Ze=L(Yn(zt,me)),N=L(Ni(zt,me)),w=Ze-N;if(Je!=null){let j=Je<0?G:ln,pe=Je<0?ln:G;Be?(Ye>0&&$e[Pe]!=null&&Z(pt.get($e[Pe]),We,N+di(Ye/2),ae,Yn(0,w-Ye),j,pe),st[Pe]!=null&&Z(at.get(st[Pe]),We,N+di(Ye/2),ae,Yn(0,w-Ye),j,pe)):Z(xn,We,N+di(Ye/2),ae,Yn(0,w-Ye),j,pe),te(m,g,Pe,We-Ye/2,N,ae+Ye,w)}}return Ye>0?bt.stroke=Be?pt:xn:Be||(bt._fill=p.width==0?p._fill:p._stroke??p._fill,bt.width=0),bt.fill=Be?at:xn,bt})}function Ov(n,e){let t=Et(e?.alignGaps,0);return(i,s,r,o)=>Er(i,s,(a,l,c,h,d,u,m,g,x,f,p)=>{[r,o]=zl(c,r,o);let M=a.pxRound,C=z=>M(u(z,h,f,g)),y=z=>M(m(z,d,p,x)),T,b,_;h.ori==0?(T=Wl,_=po,b=bg):(T=Xl,_=mo,b=wg);let v=h.dir*(h.ori==0?1:-1),D=C(l[v==1?r:o]),P=D,I=[],L=[];for(let z=v==1?r:o;z>=r&&z<=o;z+=v)if(c[z]!=null){let X=l[z],Z=C(X);I.push(P=Z),L.push(y(c[z]))}let O={stroke:n(I,L,T,_,b,M),fill:null,clip:null,band:null,gaps:null,flags:uo},R=O.stroke,[U,k]=cd(i,s);if(a.fill!=null||U!=0){let z=O.fill=new Path2D(R),$=a.fillTo(i,s,a.min,a.max,U),X=y($);_(z,P,X),_(z,D,X)}if(!a.spanGaps){let z=[];z.push(...hd(l,c,r,o,v,C,t)),O.gaps=z=a.gaps(i,s,r,o,z),O.clip=Hl(z,h.ori,g,x,f,p)}return k!=0&&(O.band=k==2?[ys(i,s,r,o,R,-1),ys(i,s,r,o,R,1)]:ys(i,s,r,o,R,k)),O})}function Bv(n){return Ov(zv,n)}function zv(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],d[u]=n[u+1]-n[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+d[u]/3,e[u]+l[u]*d[u]/3,n[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,n[u+1],e[u+1])}return a}var ju=new Set;function Gm(){for(let n of ju)n.syncRect(!0)}fo&&(br(yy,ao,Gm),br(vy,ao,Gm,!0),br(Fl,ao,()=>{In.pxRatio=At}));var kv=Ag(),Vv=Eg();function Hm(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Ju(r,o,e,t))}function Gv(n,e){return n.map((t,i)=>i==0?{}:mn({},e,t))}function Ju(n,e,t,i){return mn({},e==0?t:i,n)}function Rg(n,e,t){return e==null?co:[e,t]}var Hv=Rg;function Wv(n,e,t){return e==null?co:Ol(e,t,nd,!0)}function Cg(n,e,t,i){return e==null?co:kl(e,t,n.scales[i].log,!1)}var Xv=Cg;function Pg(n,e,t,i){return e==null?co:td(e,t,n.scales[i].log,!1)}var qv=Pg;function Yv(n,e,t,i,s){let r=Yn(Sm(n),Sm(e)),o=e-n,a=Di(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Hs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Wm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=vn((t=+s)*At))+"px"),[n,e,t]}function $v(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Vt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function In(n,e,t){let i={mode:Et(n.mode,1)},s=i.mode;function r(S,E,F,B){let Y=E.valToPct(S);return B+F*(E.dir==-1?1-Y:Y)}function o(S,E,F,B){let Y=E.valToPct(S);return B+F*(E.dir==-1?Y:1-Y)}function a(S,E,F,B){return E.ori==0?r(S,E,F,B):o(S,E,F,B)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Mi(ty);if(n.id!=null&&(c.id=n.id),ui(c,n.class),n.title){let S=Mi(sy,c);S.textContent=n.title}let h=Li("canvas"),d=i.ctx=h.getContext("2d"),u=Mi(ry,c);br("click",u,S=>{S.target===g&&(Xt!=$r||Jt!=Zr)&&Pn.click(i,S)},!0);let m=i.under=Mi(oy,u);u.appendChild(h);let g=i.over=Mi(ay,u);n=ho(n);let x=+Et(n.pxAlign,1),f=km(x);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let p=n.ms||.001,M=i.series=s==1?Hm(n.series||[],Dm,Bm,!1):Gv(n.series||[null],Om),C=i.axes=Hm(n.axes||[],Lm,Um,!0),y=i.scales={},T=i.bands=n.bands||[];T.forEach(S=>{S.fill=vt(S.fill||null),S.dir=Et(S.dir,-1)});let b=s==2?M[1].facets[0].scale:M[0].scale,_={axes:ms,series:_t},v=(n.drawOrder||["axes","series"]).map(S=>_[S]);function D(S){let E=S.distr==3?F=>xs(F>0?F:S.clamp(i,F,S.min,S.max,S.key)):S.distr==4?F=>Bu(F,S.asinh):S.distr==100?F=>S.fwd(F):F=>F;return F=>{let B=E(F),{_min:Y,_max:ee}=S,ue=ee-Y;return(B-Y)/ue}}function P(S){let E=y[S];if(E==null){let F=(n.scales||pa)[S]||pa;if(F.from!=null){P(F.from);let B=mn({},y[F.from],F,{key:S});B.valToPct=D(B),y[S]=B}else{E=y[S]=mn({},S==b?xg:Pv,F),E.key=S;let B=E.time,Y=E.range,ee=Gs(Y);if((S!=b||s==2&&!B)&&(ee&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?xm:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?xm:{mode:1,hard:Y[1],soft:Y[1]}},ee=!1),!ee&&Gl(Y))){let ue=Y;Y=(ge,Me,Ue)=>Me==null?co:Ol(Me,Ue,ue)}E.range=vt(Y||(B?Hv:S==b?E.distr==3?Xv:E.distr==4?qv:Rg:E.distr==3?Cg:E.distr==4?Pg:Wv)),E.auto=vt(ee?!1:E.auto),E.clamp=vt(E.clamp||Cv),E._min=E._max=null,E.valToPct=D(E)}}}P("x"),P("y"),s==1&&M.forEach(S=>{P(S.scale)}),C.forEach(S=>{P(S.scale)});for(let S in n.scales)P(S);let I=y[b],L=I.distr,O,R;I.ori==0?(ui(c,ny),O=r,R=o):(ui(c,iy),O=o,R=r);let U={};for(let S in y){let E=y[S];(E.min!=null||E.max!=null)&&(U[S]={min:E.min,max:E.max},E.min=E.max=null)}let k=n.tzDate||(S=>new Date(vn(S/p))),z=n.fmtDate||rd,$=p==1?nv(k):rv(k),X=Cm(k,Rm(p==1?tv:sv,z)),Z=Im(k,Pm(av,z)),te=[],oe=i.legend=mn({},hv,n.legend),ce=i.cursor=mn({},gv,{drag:{y:s==2}},n.cursor),Q=oe.show,me=ce.show,_e=oe.markers;oe.idxs=te,_e.width=vt(_e.width),_e.dash=vt(_e.dash),_e.stroke=vt(_e.stroke),_e.fill=vt(_e.fill);let ae,de,Ne,Ye=[],Be=[],st,at=!1,$e={};if(oe.live){let S=M[1]?M[1].values:null;at=S!=null,st=at?S(i,1,0):{_:0};for(let E in st)$e[E]=Qu}if(Q)if(ae=Li("table",fy,c),Ne=Li("tbody",null,ae),oe.mount(i,ae),at){de=Li("thead",null,ae,Ne);let S=Li("tr",null,de);Li("th",null,S);for(var pt in st)Li("th",rm,S).textContent=pt}else ui(ae,my),oe.live&&ui(ae,py);let Mt={show:!0},jt={show:!1};function Ct(S,E){if(E==0&&(at||!oe.live||s==2))return co;let F=[],B=Li("tr",gy,Ne,Ne.childNodes[E]);ui(B,S.class),S.show||ui(B,Mr);let Y=Li("th",null,B);if(_e.show){let ge=Mi(_y,Y);if(E>0){let Me=_e.width(i,E);Me&&(ge.style.border=Me+"px "+_e.dash(i,E)+" "+_e.stroke(i,E)),ge.style.background=_e.fill(i,E)}}let ee=Mi(rm,Y);S.label instanceof HTMLElement?ee.appendChild(S.label):ee.textContent=S.label,E>0&&(_e.show||(ee.style.color=S.width>0?_e.stroke(i,E):_e.fill(i,E)),bt("click",Y,ge=>{if(ce._lock)return;et(ge);let Me=M.indexOf(S);if((ge.ctrlKey||ge.metaKey)!=oe.isolate){let Ue=M.some((Fe,ke)=>ke>0&&ke!=Me&&Fe.show);M.forEach((Fe,ke)=>{ke>0&&Zi(ke,Ue?ke==Me?Mt:jt:Mt,!0,dn.setSeries)})}else Zi(Me,{show:!S.show},!0,dn.setSeries)},!1),tt&&bt(cm,Y,ge=>{ce._lock||(et(ge),Zi(M.indexOf(S),Jr,!0,dn.setSeries))},!1));for(var ue in st){let ge=Li("td",xy,B);ge.textContent="--",F.push(ge)}return[B,F]}let rn=new Map;function bt(S,E,F,B=!0){let Y=rn.get(E)||{},ee=ce.bind[S](i,E,F,B);ee&&(br(S,E,Y[S]=ee),rn.set(E,Y))}function xn(S,E,F){let B=rn.get(E)||{};for(let Y in B)(S==null||Y==S)&&(Xu(Y,E,B[Y]),delete B[Y]);S==null&&rn.delete(E)}let Qt=0,ln=0,G=0,Pe=0,Je=0,lt=0,Ee=Je,zt=lt,We=G,Ze=Pe,N=0,w=0,j=0,pe=0;i.bbox={};let he=!1,ve=!1,Se=!1,ie=!1,re=!1,xe=!1;function V(S,E,F){(F||S!=i.width||E!=i.height)&&le(S,E),dt(!1),Se=!0,ve=!0,Fn()}function le(S,E){i.width=Qt=G=S,i.height=ln=Pe=E,Je=lt=0,we(),Xe();let F=i.bbox;N=F.left=vr(Je*At,.5),w=F.top=vr(lt*At,.5),j=F.width=vr(G*At,.5),pe=F.height=vr(Pe*At,.5)}let se=3;function Te(){let S=!1,E=0;for(;!S;){E++;let F=Xr(E),B=$i(E);S=E==se||F&&B,S||(le(i.width,i.height),ve=!0)}}function ye({width:S,height:E}){V(S,E)}i.setSize=ye;function we(){let S=!1,E=!1,F=!1,B=!1;C.forEach((Y,ee)=>{if(Y.show&&Y._show){let{side:ue,_size:ge}=Y,Me=ue%2,Ue=Y.label!=null?Y.labelSize:0,Fe=ge+Ue;Fe>0&&(Me?(G-=Fe,ue==3?(Je+=Fe,B=!0):F=!0):(Pe-=Fe,ue==0?(lt+=Fe,S=!0):E=!0))}}),qi[0]=S,qi[1]=F,qi[2]=E,qi[3]=B,G-=Ai[1]+Ai[3],Je+=Ai[3],Pe-=Ai[2]+Ai[0],lt+=Ai[0]}function Xe(){let S=Je+G,E=lt+Pe,F=Je,B=lt;function Y(ee,ue){switch(ee){case 1:return S+=ue,S-ue;case 2:return E+=ue,E-ue;case 3:return F-=ue,F+ue;case 0:return B-=ue,B+ue}}C.forEach((ee,ue)=>{if(ee.show&&ee._show){let ge=ee.side;ee._pos=Y(ge,ee._size),ee.label!=null&&(ee._lpos=Y(ge,ee.labelSize))}})}if(ce.dataIdx==null){let S=ce.hover,E=S.skip=new Set(S.skip??[]);E.add(void 0);let F=S.prox=vt(S.prox),B=S.bias??=0;ce.dataIdx=(Y,ee,ue,ge)=>{if(ee==0)return ue;let Me=ue,Ue=F(Y,ee,ue,ge)??kt,Fe=Ue>=0&&Ue<kt,ke=I.ori==0?G:Pe,ot=ce.left,Tt=e[0],wt=e[ee];if(E.has(wt[ue])){Me=null;let xt=null,Qe=null,qe;if(B==0||B==-1)for(qe=ue;xt==null&&qe-- >0;)E.has(wt[qe])||(xt=qe);if(B==0||B==1)for(qe=ue;Qe==null&&qe++<wt.length;)E.has(wt[qe])||(Qe=qe);if(xt!=null||Qe!=null)if(Fe){let Yt=xt==null?-1/0:O(Tt[xt],I,ke,0),nn=Qe==null?1/0:O(Tt[Qe],I,ke,0),Rn=ot-Yt,Bt=nn-ot;Rn<=Bt?Rn<=Ue&&(Me=xt):Bt<=Ue&&(Me=Qe)}else Me=Qe==null?xt:xt==null?Qe:ue-xt<=Qe-ue?xt:Qe}else Fe&&Sn(ot-O(Tt[ue],I,ke,0))>Ue&&(Me=null);return Me}}let et=S=>{ce.event=S};ce.idxs=te,ce._lock=!1;let fe=ce.points;fe.show=vt(fe.show),fe.size=vt(fe.size),fe.stroke=vt(fe.stroke),fe.width=vt(fe.width),fe.fill=vt(fe.fill);let Ve=i.focus=mn({},n.focus||{alpha:.3},ce.focus),tt=Ve.prox>=0,Ce=tt&&fe.one,ut=[],Wt=[],Gn=[];function jo(S,E){let F=fe.show(i,E);if(F instanceof HTMLElement)return ui(F,dy),ui(F,S.class),ts(F,-10,-10,G,Pe),g.insertBefore(F,ut[E]),F}function Gr(S,E){if(s==1||E>0){let F=s==1&&y[S.scale].time,B=S.value;S.value=F?wm(B)?Im(k,Pm(B,z)):B||Z:B||Tv,S.label=S.label||(F?xv:_v)}if(Ce||E>0){S.width=S.width==null?1:S.width,S.paths=S.paths||kv||Py,S.fillTo=vt(S.fillTo||Iv),S.pxAlign=+Et(S.pxAlign,x),S.pxRound=km(S.pxAlign),S.stroke=vt(S.stroke||null),S.fill=vt(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let F=Av(Yn(1,S.width),1),B=S.points=mn({},{size:F,width:Yn(1,F*.2),stroke:S.stroke,space:F*2,paths:Vv,_stroke:null,_fill:null},S.points);B.show=vt(B.show),B.filter=vt(B.filter),B.fill=vt(B.fill),B.stroke=vt(B.stroke),B.paths=vt(B.paths),B.pxAlign=S.pxAlign}if(Q){let F=Ct(S,E);Ye.splice(E,0,F[0]),Be.splice(E,0,F[1]),oe.values.push(null)}if(me){te.splice(E,0,null);let F=null;Ce?E==0&&(F=jo(S,E)):E>0&&(F=jo(S,E)),ut.splice(E,0,F),Wt.splice(E,0,0),Gn.splice(E,0,0)}An("addSeries",E)}function ru(S,E){E=E??M.length,S=s==1?Ju(S,E,Dm,Bm):Ju(S,E,{},Om),M.splice(E,0,S),Gr(M[E],E)}i.addSeries=ru;function ml(S){if(M.splice(S,1),Q){oe.values.splice(S,1),Be.splice(S,1);let E=Ye.splice(S,1)[0];xn(null,E.firstChild),E.remove()}me&&(te.splice(S,1),ut.splice(S,1)[0].remove(),Wt.splice(S,1),Gn.splice(S,1)),An("delSeries",S)}i.delSeries=ml;let qi=[!1,!1,!1,!1];function ds(S,E){if(S._show=S.show,S.show){let F=S.side%2,B=y[S.scale];B==null&&(S.scale=F?M[1].scale:b,B=y[S.scale]);let Y=B.time;S.size=vt(S.size),S.space=vt(S.space),S.rotate=vt(S.rotate),Gs(S.incrs)&&S.incrs.forEach(ue=>{!Hs.has(ue)&&Hs.set(ue,Qm(ue))}),S.incrs=vt(S.incrs||(B.distr==2?Ky:Y?p==1?ev:iv:Sr)),S.splits=vt(S.splits||(Y&&B.distr==1?$:B.distr==3?Yu:B.distr==4?Sv:vv)),S.stroke=vt(S.stroke),S.grid.stroke=vt(S.grid.stroke),S.ticks.stroke=vt(S.ticks.stroke),S.border.stroke=vt(S.border.stroke);let ee=S.values;S.values=Gs(ee)&&!Gs(ee[0])?vt(ee):Y?Gs(ee)?Cm(k,Rm(ee,z)):wm(ee)?ov(k,ee):ee||X:ee||yv,S.filter=vt(S.filter||(B.distr>=3&&B.log==10?wv:B.distr==3&&B.log==2?Ev:Jm)),S.font=Wm(S.font),S.labelFont=Wm(S.labelFont),S._size=S.size(i,null,E,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(qi[E]=!0,S._el=Mi(ly,u))}}function fs(S,E,F,B){let[Y,ee,ue,ge]=F,Me=E%2,Ue=0;return Me==0&&(ge||ee)&&(Ue=E==0&&!Y||E==2&&!ue?vn(Lm.size/3):0),Me==1&&(Y||ue)&&(Ue=E==1&&!ee||E==3&&!ge?vn(Um.size/2):0),Ue}let Jo=i.padding=(n.padding||[fs,fs,fs,fs]).map(S=>vt(Et(S,fs))),Ai=i._padding=Jo.map((S,E)=>S(i,E,qi,0)),en,on=null,an=null,Yi=s==1?M[0].idxs:null,oi=null,Ds=!1;function Ko(S,E){if(e=S??[],i.data=i._data=e,s==2){en=0;for(let F=1;F<M.length;F++)en+=e[F][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),oi=e[0],en=oi.length;let F=e;if(L==2){F=e.slice();let B=F[0]=Array(en);for(let Y=0;Y<en;Y++)B[Y]=Y}i._data=e=F}if(dt(!0),An("setData"),L==2&&(Se=!0),E!==!1){let F=I;F.auto(i,Ds)?Qo():Fs(b,F.min,F.max),ie=ie||ce.left>=0,xe=!0,Fn()}}i.setData=Ko;function Qo(){Ds=!0;let S,E;s==1&&(en>0?(on=Yi[0]=0,an=Yi[1]=en-1,S=e[0][on],E=e[0][an],L==2?(S=on,E=an):S==E&&(L==3?[S,E]=kl(S,S,I.log,!1):L==4?[S,E]=td(S,S,I.log,!1):I.time?E=S+vn(86400/p):[S,E]=Ol(S,E,nd,!0))):(on=Yi[0]=S=null,an=Yi[1]=E=null)),Fs(b,S,E)}let Hr,Ns,Wr,A,W,ne,J,K,Ae,Le;function Re(S,E,F,B,Y,ee){S??=am,F??=sd,B??="butt",Y??=am,ee??="round",S!=Hr&&(d.strokeStyle=Hr=S),Y!=Ns&&(d.fillStyle=Ns=Y),E!=Wr&&(d.lineWidth=Wr=E),ee!=W&&(d.lineJoin=W=ee),B!=ne&&(d.lineCap=ne=B),F!=A&&d.setLineDash(A=F)}function De(S,E,F,B){E!=Ns&&(d.fillStyle=Ns=E),S!=J&&(d.font=J=S),F!=K&&(d.textAlign=K=F),B!=Ae&&(d.textBaseline=Ae=B)}function He(S,E,F,B,Y=0){if(B.length>0&&S.auto(i,Ds)&&(E==null||E.min==null)){let ee=Et(on,0),ue=Et(an,B.length-1),ge=F.min==null?wy(B,ee,ue,Y,S.distr==3):[F.min,F.max];S.min=Ni(S.min,F.min=ge[0]),S.max=Yn(S.max,F.max=ge[1])}}let nt={min:null,max:null};function gt(){for(let B in y){let Y=y[B];U[B]==null&&(Y.min==null||U[b]!=null&&Y.auto(i,Ds))&&(U[B]=nt)}for(let B in y){let Y=y[B];U[B]==null&&Y.from!=null&&U[Y.from]!=null&&(U[B]=nt)}U[b]!=null&&dt(!0);let S={};for(let B in U){let Y=U[B];if(Y!=null){let ee=S[B]=ho(y[B],Dy);if(Y.min!=null)mn(ee,Y);else if(B!=b||s==2)if(en==0&&ee.from==null){let ue=ee.range(i,null,null,B);ee.min=ue[0],ee.max=ue[1]}else ee.min=kt,ee.max=-kt}}if(en>0){M.forEach((B,Y)=>{if(s==1){let ee=B.scale,ue=U[ee];if(ue==null)return;let ge=S[ee];if(Y==0){let Me=ge.range(i,ge.min,ge.max,ee);ge.min=Me[0],ge.max=Me[1],on=Di(ge.min,e[0]),an=Di(ge.max,e[0]),an-on>1&&(e[0][on]<ge.min&&on++,e[0][an]>ge.max&&an--),B.min=oi[on],B.max=oi[an]}else B.show&&B.auto&&He(ge,ue,B,e[Y],B.sorted);B.idxs[0]=on,B.idxs[1]=an}else if(Y>0&&B.show&&B.auto){let[ee,ue]=B.facets,ge=ee.scale,Me=ue.scale,[Ue,Fe]=e[Y],ke=S[ge],ot=S[Me];ke!=null&&He(ke,U[ge],ee,Ue,ee.sorted),ot!=null&&He(ot,U[Me],ue,Fe,ue.sorted),B.min=ue.min,B.max=ue.max}});for(let B in S){let Y=S[B],ee=U[B];if(Y.from==null&&(ee==null||ee.min==null)){let ue=Y.range(i,Y.min==kt?null:Y.min,Y.max==-kt?null:Y.max,B);Y.min=ue[0],Y.max=ue[1]}}}for(let B in S){let Y=S[B];if(Y.from!=null){let ee=S[Y.from];if(ee.min==null)Y.min=Y.max=null;else{let ue=Y.range(i,ee.min,ee.max,B);Y.min=ue[0],Y.max=ue[1]}}}let E={},F=!1;for(let B in S){let Y=S[B],ee=y[B];if(ee.min!=Y.min||ee.max!=Y.max){ee.min=Y.min,ee.max=Y.max;let ue=ee.distr;ee._min=ue==3?xs(ee.min):ue==4?Bu(ee.min,ee.asinh):ue==100?ee.fwd(ee.min):ee.min,ee._max=ue==3?xs(ee.max):ue==4?Bu(ee.max,ee.asinh):ue==100?ee.fwd(ee.max):ee.max,E[B]=F=!0}}if(F){M.forEach((B,Y)=>{s==2?Y>0&&E.y&&(B._paths=null):E[B.scale]&&(B._paths=null)});for(let B in E)Se=!0,An("setScale",B);me&&ce.left>=0&&(ie=xe=!0)}for(let B in U)U[B]=null}function Ge(S){let E=qu(on-1,0,en-1),F=qu(an+1,0,en-1);for(;S[E]==null&&E>0;)E--;for(;S[F]==null&&F<en-1;)F++;return[E,F]}function _t(){if(en>0){let S=M.some(E=>E._focus)&&Le!=Ve.alpha;S&&(d.globalAlpha=Le=Ve.alpha),M.forEach((E,F)=>{if(F>0&&E.show&&(Kt(F,!1),Kt(F,!0),E._paths==null)){let B=Le;Le!=E.alpha&&(d.globalAlpha=Le=E.alpha);let Y=s==2?[0,e[F][0].length-1]:Ge(e[F]);E._paths=E.paths(i,F,Y[0],Y[1]),Le!=B&&(d.globalAlpha=Le=B)}}),M.forEach((E,F)=>{if(F>0&&E.show){let B=Le;Le!=E.alpha&&(d.globalAlpha=Le=E.alpha),E._paths!=null&&Nt(F,!1);{let Y=E._paths!=null?E._paths.gaps:null,ee=E.points.show(i,F,on,an,Y),ue=E.points.filter(i,F,ee,Y);(ee||ue)&&(E.points._paths=E.points.paths(i,F,on,an,ue),Nt(F,!0))}Le!=B&&(d.globalAlpha=Le=B),An("drawSeries",F)}}),S&&(d.globalAlpha=Le=1)}}function Kt(S,E){let F=E?M[S].points:M[S];F._stroke=F.stroke(i,S),F._fill=F.fill(i,S)}function Nt(S,E){let F=E?M[S].points:M[S],{stroke:B,fill:Y,clip:ee,flags:ue,_stroke:ge=F._stroke,_fill:Me=F._fill,_width:Ue=F.width}=F._paths;Ue=Vt(Ue*At,3);let Fe=null,ke=Ue%2/2;E&&Me==null&&(Me=Ue>0?"#fff":ge);let ot=F.pxAlign==1&&ke>0;if(ot&&d.translate(ke,ke),!E){let Tt=N-Ue/2,wt=w-Ue/2,xt=j+Ue,Qe=pe+Ue;Fe=new Path2D,Fe.rect(Tt,wt,xt,Qe)}E?ze(ge,Ue,F.dash,F.cap,Me,B,Y,ue,ee):Ut(S,ge,Ue,F.dash,F.cap,Me,B,Y,ue,Fe,ee),ot&&d.translate(-ke,-ke)}function Ut(S,E,F,B,Y,ee,ue,ge,Me,Ue,Fe){let ke=!1;Me!=0&&T.forEach((ot,Tt)=>{if(ot.series[0]==S){let wt=M[ot.series[1]],xt=e[ot.series[1]],Qe=(wt._paths||pa).band;Gs(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let qe,Yt=null;wt.show&&Qe&&Ty(xt,on,an)?(Yt=ot.fill(i,Tt)||ee,qe=wt._paths.clip):Qe=null,ze(E,F,B,Y,Yt,ue,ge,Me,Ue,Fe,qe,Qe),ke=!0}}),ke||ze(E,F,B,Y,ee,ue,ge,Me,Ue,Fe)}let yn=uo|Zu;function ze(S,E,F,B,Y,ee,ue,ge,Me,Ue,Fe,ke){Re(S,E,F,B,Y),(Me||Ue||ke)&&(d.save(),Me&&d.clip(Me),Ue&&d.clip(Ue)),ke?(ge&yn)==yn?(d.clip(ke),Fe&&d.clip(Fe),yt(Y,ue),cn(S,ee,E)):ge&Zu?(yt(Y,ue),d.clip(ke),cn(S,ee,E)):ge&uo&&(d.save(),d.clip(ke),Fe&&d.clip(Fe),yt(Y,ue),d.restore(),cn(S,ee,E)):(yt(Y,ue),cn(S,ee,E)),(Me||Ue||ke)&&d.restore()}function cn(S,E,F){F>0&&(E instanceof Map?E.forEach((B,Y)=>{d.strokeStyle=Hr=Y,d.stroke(B)}):E!=null&&S&&d.stroke(E))}function yt(S,E){E instanceof Map?E.forEach((F,B)=>{d.fillStyle=Ns=B,d.fill(F)}):E!=null&&S&&d.fill(E)}function ps(S,E,F,B){let Y=C[S],ee;if(B<=0)ee=[0,0];else{let ue=Y._space=Y.space(i,S,E,F,B),ge=Y._incrs=Y.incrs(i,S,E,F,B,ue);ee=Yv(E,F,ge,B,ue)}return Y._found=ee}function hn(S,E,F,B,Y,ee,ue,ge,Me,Ue){let Fe=ue%2/2;x==1&&d.translate(Fe,Fe),Re(ge,ue,Me,Ue,ge),d.beginPath();let ke,ot,Tt,wt,xt=Y+(B==0||B==3?-ee:ee);F==0?(ot=Y,wt=xt):(ke=Y,Tt=xt);for(let Qe=0;Qe<S.length;Qe++)E[Qe]!=null&&(F==0?ke=Tt=S[Qe]:ot=wt=S[Qe],d.moveTo(ke,ot),d.lineTo(Tt,wt));d.stroke(),x==1&&d.translate(-Fe,-Fe)}function Xr(S){let E=!0;return C.forEach((F,B)=>{if(!F.show)return;let Y=y[F.scale];if(Y.min==null){F._show&&(E=!1,F._show=!1,dt(!1));return}else F._show||(E=!1,F._show=!0,dt(!1));let ee=F.side,ue=ee%2,{min:ge,max:Me}=Y,[Ue,Fe]=ps(B,ge,Me,ue==0?G:Pe);if(Fe==0)return;let ke=Y.distr==2,ot=F._splits=F.splits(i,B,ge,Me,Ue,Fe,ke),Tt=Y.distr==2?ot.map(qe=>oi[qe]):ot,wt=Y.distr==2?oi[ot[1]]-oi[ot[0]]:Ue,xt=F._values=F.values(i,F.filter(i,Tt,B,Fe,wt),B,Fe,wt);F._rotate=ee==2?F.rotate(i,xt,B,Fe):0;let Qe=F._size;F._size=bi(F.size(i,xt,B,S)),Qe!=null&&F._size!=Qe&&(E=!1)}),E}function $i(S){let E=!0;return Jo.forEach((F,B)=>{let Y=F(i,B,qi,S);Y!=Ai[B]&&(E=!1),Ai[B]=Y}),E}function ms(){for(let S=0;S<C.length;S++){let E=C[S];if(!E.show||!E._show)continue;let F=E.side,B=F%2,Y,ee,ue=E.stroke(i,S),ge=F==0||F==3?-1:1,[Me,Ue]=E._found;if(E.label!=null){let Xn=E.labelGap*ge,ci=vn((E._lpos+Xn)*At);De(E.labelFont[0],ue,"center",F==2?"top":om),d.save(),B==1?(Y=ee=0,d.translate(ci,vn(w+pe/2)),d.rotate((F==3?-Ul:Ul)/2)):(Y=vn(N+j/2),ee=ci);let pr=Zm(E.label)?E.label(i,S,Me,Ue):E.label;d.fillText(pr,Y,ee),d.restore()}if(Ue==0)continue;let Fe=y[E.scale],ke=B==0?j:pe,ot=B==0?N:w,Tt=E._splits,wt=Fe.distr==2?Tt.map(Xn=>oi[Xn]):Tt,xt=Fe.distr==2?oi[Tt[1]]-oi[Tt[0]]:Me,Qe=E.ticks,qe=E.border,Yt=Qe.show?Qe.size:0,nn=vn(Yt*At),Rn=vn((E.alignTo==2?E._size-Yt-E.gap:E.gap)*At),Bt=E._rotate*-Ul/180,sn=f(E._pos*At),ai=(nn+Rn)*ge,Wn=sn+ai;ee=B==0?Wn:0,Y=B==1?Wn:0;let vi=E.font[0],Ri=E.align==1?ro:E.align==2?Uu:Bt>0?ro:Bt<0?Uu:B==0?"center":F==3?Uu:ro,Ji=Bt||B==1?"middle":F==2?"top":om;De(vi,ue,Ri,Ji);let li=E.font[1]*E.lineGap,Si=Tt.map(Xn=>f(a(Xn,Fe,ke,ot))),Ci=E._values;for(let Xn=0;Xn<Ci.length;Xn++){let ci=Ci[Xn];if(ci!=null){B==0?Y=Si[Xn]:ee=Si[Xn],ci=""+ci;let pr=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let qn=0;qn<pr.length;qn++){let hp=pr[qn];Bt?(d.save(),d.translate(Y,ee+qn*li),d.rotate(Bt),d.fillText(hp,0,0),d.restore()):d.fillText(hp,Y,ee+qn*li)}}}Qe.show&&hn(Si,Qe.filter(i,wt,S,Ue,xt),B,F,sn,nn,Vt(Qe.width*At,3),Qe.stroke(i,S),Qe.dash,Qe.cap);let Ki=E.grid;Ki.show&&hn(Si,Ki.filter(i,wt,S,Ue,xt),B,B==0?2:1,B==0?w:N,B==0?pe:j,Vt(Ki.width*At,3),Ki.stroke(i,S),Ki.dash,Ki.cap),qe.show&&hn([sn],[1],B==0?1:0,B==0?1:2,B==1?w:N,B==1?pe:j,Vt(qe.width*At,3),qe.stroke(i,S),qe.dash,qe.cap)}An("drawAxes")}function dt(S){M.forEach((E,F)=>{F>0&&(E._paths=null,S&&(s==1?(E.min=null,E.max=null):E.facets.forEach(B=>{B.min=null,B.max=null})))})}let tn=!1,Hn=!1,Ft=[];function un(){Hn=!1;for(let S=0;S<Ft.length;S++)An(...Ft[S]);Ft.length=0}function Fn(){tn||(ky(qf),tn=!0)}function gl(S,E=!1){tn=!0,Hn=E,S(i),qf(),E&&Ft.length>0&&queueMicrotask(un)}i.batch=gl;function qf(){if(he&&(gt(),he=!1),Se&&(Te(),Se=!1),ve){if($t(m,ro,Je),$t(m,"top",lt),$t(m,ha,G),$t(m,ua,Pe),$t(g,ro,Je),$t(g,"top",lt),$t(g,ha,G),$t(g,ua,Pe),$t(u,ha,Qt),$t(u,ua,ln),h.width=vn(Qt*At),h.height=vn(ln*At),C.forEach(({_el:S,_show:E,_size:F,_pos:B,side:Y})=>{if(S!=null)if(E){let ee=Y===3||Y===0?F:0,ue=Y%2==1;$t(S,ue?"left":"top",B-ee),$t(S,ue?"width":"height",F),$t(S,ue?"top":"left",ue?lt:Je),$t(S,ue?"height":"width",ue?Pe:G),Wu(S,Mr)}else ui(S,Mr)}),Hr=Ns=Wr=W=ne=J=K=Ae=A=null,Le=1,na(!0),Je!=Ee||lt!=zt||G!=We||Pe!=Ze){dt(!1);let S=G/We,E=Pe/Ze;if(me&&!ie&&ce.left>=0){ce.left*=S,ce.top*=E,qr&&ts(qr,vn(ce.left),0,G,Pe),Yr&&ts(Yr,0,vn(ce.top),G,Pe);for(let F=0;F<ut.length;F++){let B=ut[F];B!=null&&(Wt[F]*=S,Gn[F]*=E,ts(B,bi(Wt[F]),bi(Gn[F]),G,Pe))}}if(qt.show&&!re&&qt.left>=0&&qt.width>0){qt.left*=S,qt.width*=S,qt.top*=E,qt.height*=E;for(let F in uu)$t(jr,F,qt[F])}Ee=Je,zt=lt,We=G,Ze=Pe}An("setSize"),ve=!1}Qt>0&&ln>0&&(d.clearRect(0,0,h.width,h.height),An("drawClear"),v.forEach(S=>S()),An("draw")),qt.show&&re&&(_l(qt),re=!1),me&&ie&&(fr(null,!0,!1),ie=!1),oe.show&&oe.live&&xe&&(cu(),xe=!1),l||(l=!0,i.status=1,An("ready")),Ds=!1,tn=!1}i.redraw=(S,E)=>{Se=E||!1,S!==!1?Fs(b,I.min,I.max):Fn()};function ou(S,E){let F=y[S];if(F.from==null){if(en==0){let B=F.range(i,E.min,E.max,S);E.min=B[0],E.max=B[1]}if(E.min>E.max){let B=E.min;E.min=E.max,E.max=B}if(en>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;S==b&&F.distr==2&&en>0&&(E.min=Di(E.min,e[0]),E.max=Di(E.max,e[0]),E.min==E.max&&E.max++),U[S]=E,he=!0,Fn()}}i.setScale=ou;let au,lu,qr,Yr,Yf,$f,$r,Zr,Zf,jf,Xt,Jt,Us=!1,Pn=ce.drag,En=Pn.x,Tn=Pn.y;me&&(ce.x&&(au=Mi(hy,g)),ce.y&&(lu=Mi(uy,g)),I.ori==0?(qr=au,Yr=lu):(qr=lu,Yr=au),Xt=ce.left,Jt=ce.top);let qt=i.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),jr=qt.show?Mi(cy,qt.over?g:m):null;function _l(S,E){if(qt.show){for(let F in S)qt[F]=S[F],F in uu&&$t(jr,F,S[F]);E!==!1&&An("setSelect")}}i.setSelect=_l;function K_(S){if(M[S].show)Q&&Wu(Ye[S],Mr);else if(Q&&ui(Ye[S],Mr),me){let F=Ce?ut[0]:ut[S];F!=null&&ts(F,-10,-10,G,Pe)}}function Fs(S,E,F){ou(S,{min:E,max:F})}function Zi(S,E,F,B){E.focus!=null&&ix(S),E.show!=null&&M.forEach((Y,ee)=>{ee>0&&(S==ee||S==null)&&(Y.show=E.show,K_(ee),s==2?(Fs(Y.facets[0].scale,null,null),Fs(Y.facets[1].scale,null,null)):Fs(Y.scale,null,null),Fn())}),F!==!1&&An("setSeries",S,E),B&&ia("setSeries",i,S,E)}i.setSeries=Zi;function Q_(S,E){mn(T[S],E)}function ex(S,E){S.fill=vt(S.fill||null),S.dir=Et(S.dir,-1),E=E??T.length,T.splice(E,0,S)}function tx(S){S==null?T.length=0:T.splice(S,1)}i.addBand=ex,i.setBand=Q_,i.delBand=tx;function nx(S,E){M[S].alpha=E,me&&ut[S]!=null&&(ut[S].style.opacity=E),Q&&Ye[S]&&(Ye[S].style.opacity=E)}let gs,Os,dr,Jr={focus:!0};function ix(S){if(S!=dr){let E=S==null,F=Ve.alpha!=1;M.forEach((B,Y)=>{if(s==1||Y>0){let ee=E||Y==0||Y==S;B._focus=E?null:ee,F&&nx(Y,ee?1:Ve.alpha)}}),dr=S,F&&Fn()}}Q&&tt&&bt(hm,ae,S=>{ce._lock||(et(S),dr!=null&&Zi(null,Jr,!0,dn.setSeries))});function ji(S,E,F){let B=y[E];F&&(S=S/At-(B.ori==1?lt:Je));let Y=G;B.ori==1&&(Y=Pe,S=Y-S),B.dir==-1&&(S=Y-S);let ee=B._min,ue=B._max,ge=S/Y,Me=ee+(ue-ee)*ge,Ue=B.distr;return Ue==3?lo(10,Me):Ue==4?Ry(Me,B.asinh):Ue==100?B.bwd(Me):Me}function sx(S,E){let F=ji(S,b,E);return Di(F,e[0],on,an)}i.valToIdx=S=>Di(S,e[0]),i.posToIdx=sx,i.posToVal=ji,i.valToPos=(S,E,F)=>y[E].ori==0?r(S,y[E],F?j:G,F?N:0):o(S,y[E],F?pe:Pe,F?w:0),i.setCursor=(S,E,F)=>{Xt=S.left,Jt=S.top,fr(null,E,F)};function Jf(S,E){$t(jr,ro,qt.left=S),$t(jr,ha,qt.width=E)}function Kf(S,E){$t(jr,"top",qt.top=S),$t(jr,ua,qt.height=E)}let ea=I.ori==0?Jf:Kf,ta=I.ori==1?Jf:Kf;function rx(){if(Q&&oe.live)for(let S=s==2?1:0;S<M.length;S++){if(S==0&&at)continue;let E=oe.values[S],F=0;for(let B in E)Be[S][F++].firstChild.nodeValue=E[B]}}function cu(S,E){if(S!=null&&(S.idxs?S.idxs.forEach((F,B)=>{te[B]=F}):Ly(S.idx)||te.fill(S.idx),oe.idx=te[0]),Q&&oe.live){for(let F=0;F<M.length;F++)(F>0||s==1&&!at)&&ox(F,te[F]);rx()}xe=!1,E!==!1&&An("setLegend")}i.setLegend=cu;function ox(S,E){let F=M[S],B=S==0&&L==2?oi:e[S],Y;at?Y=F.values(i,S,E)??$e:(Y=F.value(i,E==null?null:B[E],S,E),Y=Y==null?$e:{_:Y}),oe.values[S]=Y}function fr(S,E,F){Zf=Xt,jf=Jt,[Xt,Jt]=ce.move(i,Xt,Jt),ce.left=Xt,ce.top=Jt,me&&(qr&&ts(qr,vn(Xt),0,G,Pe),Yr&&ts(Yr,0,vn(Jt),G,Pe));let B,Y=on>an;gs=kt,Os=null;let ee=I.ori==0?G:Pe,ue=I.ori==1?G:Pe;if(Xt<0||en==0||Y){B=ce.idx=null;for(let ge=0;ge<M.length;ge++){let Me=ut[ge];Me!=null&&ts(Me,-10,-10,G,Pe)}tt&&Zi(null,Jr,!0,S==null&&dn.setSeries),oe.live&&(te.fill(B),xe=!0)}else{let ge,Me,Ue;s==1&&(ge=I.ori==0?Xt:Jt,Me=ji(ge,b),B=ce.idx=Di(Me,e[0],on,an),Ue=O(e[0][B],I,ee,0));let Fe=-10,ke=-10,ot=0,Tt=0,wt=!0,xt="",Qe="";for(let qe=s==2?1:0;qe<M.length;qe++){let Yt=M[qe],nn=te[qe],Rn=nn==null?null:s==1?e[qe][nn]:e[qe][1][nn],Bt=ce.dataIdx(i,qe,B,Me),sn=Bt==null?null:s==1?e[qe][Bt]:e[qe][1][Bt];if(xe=xe||sn!=Rn||Bt!=nn,te[qe]=Bt,qe>0&&Yt.show){let ai=Bt==null?-10:Bt==B?Ue:O(s==1?e[0][Bt]:e[qe][0][Bt],I,ee,0),Wn=sn==null?-10:R(sn,s==1?y[Yt.scale]:y[Yt.facets[1].scale],ue,0);if(tt&&sn!=null){let vi=I.ori==1?Xt:Jt,Ri=Sn(Ve.dist(i,qe,Bt,Wn,vi));if(Ri<gs){let Ji=Ve.bias;if(Ji!=0){let li=ji(vi,Yt.scale),Si=sn>=0?1:-1,Ci=li>=0?1:-1;Ci==Si&&(Ci==1?Ji==1?sn>=li:sn<=li:Ji==1?sn<=li:sn>=li)&&(gs=Ri,Os=qe)}else gs=Ri,Os=qe}}if(xe||Ce){let vi,Ri;I.ori==0?(vi=ai,Ri=Wn):(vi=Wn,Ri=ai);let Ji,li,Si,Ci,Ki,Xn,ci=!0,pr=fe.bbox;if(pr!=null){ci=!1;let qn=pr(i,qe);Si=qn.left,Ci=qn.top,Ji=qn.width,li=qn.height}else Si=vi,Ci=Ri,Ji=li=fe.size(i,qe);if(Xn=fe.fill(i,qe),Ki=fe.stroke(i,qe),Ce)qe==Os&&gs<=Ve.prox&&(Fe=Si,ke=Ci,ot=Ji,Tt=li,wt=ci,xt=Xn,Qe=Ki);else{let qn=ut[qe];qn!=null&&(Wt[qe]=Si,Gn[qe]=Ci,_m(qn,Ji,li,ci),mm(qn,Xn,Ki),ts(qn,bi(Si),bi(Ci),G,Pe))}}}}if(Ce){let qe=Ve.prox,Yt=dr==null?gs<=qe:gs>qe||Os!=dr;if(xe||Yt){let nn=ut[0];nn!=null&&(Wt[0]=Fe,Gn[0]=ke,_m(nn,ot,Tt,wt),mm(nn,xt,Qe),ts(nn,bi(Fe),bi(ke),G,Pe))}}}if(qt.show&&Us)if(S!=null){let[ge,Me]=dn.scales,[Ue,Fe]=dn.match,[ke,ot]=S.cursor.sync.scales,Tt=S.cursor.drag;if(En=Tt._x,Tn=Tt._y,En||Tn){let{left:wt,top:xt,width:Qe,height:qe}=S.select,Yt=S.scales[ke].ori,nn=S.posToVal,Rn,Bt,sn,ai,Wn,vi=ge!=null&&Ue(ge,ke),Ri=Me!=null&&Fe(Me,ot);vi&&En?(Yt==0?(Rn=wt,Bt=Qe):(Rn=xt,Bt=qe),sn=y[ge],ai=O(nn(Rn,ke),sn,ee,0),Wn=O(nn(Rn+Bt,ke),sn,ee,0),ea(Ni(ai,Wn),Sn(Wn-ai))):ea(0,ee),Ri&&Tn?(Yt==1?(Rn=wt,Bt=Qe):(Rn=xt,Bt=qe),sn=y[Me],ai=R(nn(Rn,ot),sn,ue,0),Wn=R(nn(Rn+Bt,ot),sn,ue,0),ta(Ni(ai,Wn),Sn(Wn-ai))):ta(0,ue)}else du()}else{let ge=Sn(Zf-Yf),Me=Sn(jf-$f);if(I.ori==1){let ot=ge;ge=Me,Me=ot}En=Pn.x&&ge>=Pn.dist,Tn=Pn.y&&Me>=Pn.dist;let Ue=Pn.uni;Ue!=null?En&&Tn&&(En=ge>=Ue,Tn=Me>=Ue,!En&&!Tn&&(Me>ge?Tn=!0:En=!0)):Pn.x&&Pn.y&&(En||Tn)&&(En=Tn=!0);let Fe,ke;En&&(I.ori==0?(Fe=$r,ke=Xt):(Fe=Zr,ke=Jt),ea(Ni(Fe,ke),Sn(ke-Fe)),Tn||ta(0,ue)),Tn&&(I.ori==1?(Fe=$r,ke=Xt):(Fe=Zr,ke=Jt),ta(Ni(Fe,ke),Sn(ke-Fe)),En||ea(0,ee)),!En&&!Tn&&(ea(0,0),ta(0,0))}if(Pn._x=En,Pn._y=Tn,S==null){if(F){if(cp!=null){let[ge,Me]=dn.scales;dn.values[0]=ge!=null?ji(I.ori==0?Xt:Jt,ge):null,dn.values[1]=Me!=null?ji(I.ori==1?Xt:Jt,Me):null}ia(Fu,i,Xt,Jt,G,Pe,B)}if(tt){let ge=F&&dn.setSeries,Me=Ve.prox;dr==null?gs<=Me&&Zi(Os,Jr,!0,ge):gs>Me?Zi(null,Jr,!0,ge):Os!=dr&&Zi(Os,Jr,!0,ge)}}xe&&(oe.idx=B,cu()),E!==!1&&An("setCursor")}let Bs=null;Object.defineProperty(i,"rect",{get(){return Bs==null&&na(!1),Bs}});function na(S=!1){S?Bs=null:(Bs=g.getBoundingClientRect(),An("syncRect",Bs))}function Qf(S,E,F,B,Y,ee,ue){ce._lock||Us&&S!=null&&S.movementX==0&&S.movementY==0||(hu(S,E,F,B,Y,ee,ue,!1,S!=null),S!=null?fr(null,!0,!0):fr(E,!0,!1))}function hu(S,E,F,B,Y,ee,ue,ge,Me){if(Bs==null&&na(!1),et(S),S!=null)F=S.clientX-Bs.left,B=S.clientY-Bs.top;else{if(F<0||B<0){Xt=-10,Jt=-10;return}let[Ue,Fe]=dn.scales,ke=E.cursor.sync,[ot,Tt]=ke.values,[wt,xt]=ke.scales,[Qe,qe]=dn.match,Yt=E.axes[0].side%2==1,nn=I.ori==0?G:Pe,Rn=I.ori==1?G:Pe,Bt=Yt?ee:Y,sn=Yt?Y:ee,ai=Yt?B:F,Wn=Yt?F:B;if(wt!=null?F=Qe(Ue,wt)?a(ot,y[Ue],nn,0):-10:F=nn*(ai/Bt),xt!=null?B=qe(Fe,xt)?a(Tt,y[Fe],Rn,0):-10:B=Rn*(Wn/sn),I.ori==1){let vi=F;F=B,B=vi}}Me&&(E==null||E.cursor.event.type==Fu)&&((F<=1||F>=G-1)&&(F=vr(F,G)),(B<=1||B>=Pe-1)&&(B=vr(B,Pe))),ge?(Yf=F,$f=B,[$r,Zr]=ce.move(i,F,B)):(Xt=F,Jt=B)}let uu={width:0,height:0,left:0,top:0};function du(){_l(uu,!1)}let ep,tp,np,ip;function sp(S,E,F,B,Y,ee,ue){Us=!0,En=Tn=Pn._x=Pn._y=!1,hu(S,E,F,B,Y,ee,ue,!0,!1),S!=null&&(bt(Ou,Gu,rp,!1),ia(lm,i,$r,Zr,G,Pe,null));let{left:ge,top:Me,width:Ue,height:Fe}=qt;ep=ge,tp=Me,np=Ue,ip=Fe}function rp(S,E,F,B,Y,ee,ue){Us=Pn._x=Pn._y=!1,hu(S,E,F,B,Y,ee,ue,!1,!0);let{left:ge,top:Me,width:Ue,height:Fe}=qt,ke=Ue>0||Fe>0,ot=ep!=ge||tp!=Me||np!=Ue||ip!=Fe;if(ke&&ot&&_l(qt),Pn.setScale&&ke&&ot){let Tt=ge,wt=Ue,xt=Me,Qe=Fe;if(I.ori==1&&(Tt=Me,wt=Fe,xt=ge,Qe=Ue),En&&Fs(b,ji(Tt,b),ji(Tt+wt,b)),Tn)for(let qe in y){let Yt=y[qe];qe!=b&&Yt.from==null&&Yt.min!=kt&&Fs(qe,ji(xt+Qe,qe),ji(xt,qe))}du()}else ce.lock&&(ce._lock=!ce._lock,fr(E,!0,S!=null));S!=null&&(xn(Ou,Gu),ia(Ou,i,Xt,Jt,G,Pe,null))}function ax(S,E,F,B,Y,ee,ue){if(ce._lock)return;et(S);let ge=Us;if(Us){let Me=!0,Ue=!0,Fe=10,ke,ot;I.ori==0?(ke=En,ot=Tn):(ke=Tn,ot=En),ke&&ot&&(Me=Xt<=Fe||Xt>=G-Fe,Ue=Jt<=Fe||Jt>=Pe-Fe),ke&&Me&&(Xt=Xt<$r?0:G),ot&&Ue&&(Jt=Jt<Zr?0:Pe),fr(null,!0,!0),Us=!1}Xt=-10,Jt=-10,te.fill(null),fr(null,!0,!0),ge&&(Us=ge)}function op(S,E,F,B,Y,ee,ue){ce._lock||(et(S),Qo(),du(),S!=null&&ia(um,i,Xt,Jt,G,Pe,null))}function ap(){C.forEach($v),V(i.width,i.height,!0)}br(Fl,ao,ap);let Kr={};Kr.mousedown=sp,Kr.mousemove=Qf,Kr.mouseup=rp,Kr.dblclick=op,Kr.setSeries=(S,E,F,B)=>{let Y=dn.match[2];F=Y(i,E,F),F!=-1&&Zi(F,B,!0,!1)},me&&(bt(lm,g,sp),bt(Fu,g,Qf),bt(cm,g,S=>{et(S),na(!1)}),bt(hm,g,ax),bt(um,g,op),ju.add(i),i.syncRect=na);let xl=i.hooks=n.hooks||{};function An(S,E,F){Hn?Ft.push([S,E,F]):S in xl&&xl[S].forEach(B=>{B.call(null,i,E,F)})}(n.plugins||[]).forEach(S=>{for(let E in S.hooks)xl[E]=(xl[E]||[]).concat(S.hooks[E])});let lp=(S,E,F)=>F,dn=mn({key:null,setSeries:!1,filters:{pub:Mm,sub:Mm},scales:[b,M[1]?M[1].scale:null],match:[bm,bm,lp],values:[null,null]},ce.sync);dn.match.length==2&&dn.match.push(lp),ce.sync=dn;let cp=dn.key,fu=yg(cp);function ia(S,E,F,B,Y,ee,ue){dn.filters.pub(S,E,F,B,Y,ee,ue)&&fu.pub(S,E,F,B,Y,ee,ue)}fu.sub(i);function lx(S,E,F,B,Y,ee,ue){dn.filters.sub(S,E,F,B,Y,ee,ue)&&Kr[S](null,E,F,B,Y,ee,ue)}i.pub=lx;function cx(){fu.unsub(i),ju.delete(i),rn.clear(),Xu(Fl,ao,ap),c.remove(),ae?.remove(),An("destroy")}i.destroy=cx;function pu(){An("init",n,e),Ko(e||n.data,!1),U[b]?ou(b,U[b]):Qo(),re=qt.show&&(qt.width>0||qt.height>0),ie=xe=!0,V(n.width,n.height)}return M.forEach(Gr),C.forEach(ds),t?t instanceof HTMLElement?(t.appendChild(c),pu()):t(i,pu):pu(),i}In.assign=mn;In.fmtNum=id;In.rangeNum=Ol;In.rangeLog=kl;In.rangeAsinh=td;In.orient=Er;In.pxRatio=At;In.join=zy;In.fmtDate=rd,In.tzDate=jy;In.sync=yg;{In.addGap=Lv,In.clipGaps=Hl;let n=In.paths={points:Eg};n.linear=Ag,n.stepped=Uv,n.bars=Fv,n.spline=Bv}var Zv="robot-dynamics",Tr=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim();function jv(n){let{joints:e,ofBase:t,units:i,trajectory:s}=n,{name:r}=n.tip(),o=(d,u,m)=>({values:s[d].map(g=>g[u]*m),now:g=>g[d][u]*m}),a=(d,u,m,g)=>({key:d,title:u,curves:e.map((x,f)=>({joint:f,name:x.name,unit:m(x.type),color:`--joint-${f%8}`,isDashed:f>=8,...o(d,d==="q"?f:t+f,g?i.factor(x.type):1)}))}),l=(d,u,m,g,x,f)=>({joint:null,name:d,sign:u,values:m,unit:g,color:x,now:f}),c=d=>s.tip.map(u=>u[d]),h=[a("q",["q","positions"],i.position,!0),a("qd",["q\u0307","velocities"],i.velocity,!0),a("qdd",["q\u0308","accelerations"],i.acceleration,!0),a("tau",["\u03C4","torques and forces"],i.force,!1),{key:"energy",title:["E","energies"],curves:[l("kinetic","T",s.kinetic,"J","--joint-0",({kinetic:d})=>d),l("potential","U",s.potential,"J","--joint-1",({potential:d})=>d),l("total","T+U",s.total,"J","--ink",({kinetic:d,potential:u})=>d+u)]},{key:"tip",title:["p",r],curves:[0,1,2].map(d=>l("xyz"[d],"xyz"[d],c(d),"m",`--axis-${"xyz"[d]}`,({tip:u})=>u[d][3]))}];return t>0?[...h.filter(({curves:d})=>d.length>0),...Jv(n,o,l)]:h}function Jv({freedoms:n,ofBase:e,units:t,trajectory:i},s,r){let o=(h,d,u,m,g)=>({key:`base-${h}`,title:d,curves:n.slice(0,e).map((x,f)=>({joint:null,name:x.name,sign:u(x),unit:m(x.type),color:`--axis-${x.axis}`,isDashed:f>=3,...s(h,f,g?t.factor(x.type):1)}))}),a=[0,1,2].map(h=>{let d=({base:u})=>_s(u)[h];return r("xyz"[h],"xyz"[h],i.base.map(u=>d({base:u})),"m",`--axis-${"xyz"[h]}`,d)}),l=({velocity:h,axis:d})=>`${h}${d}`,c=({force:h,axis:d})=>`${h}${d}`;return[{key:"base",title:["p","base"],curves:a},o("qd",["v, \u03C9","of the base"],l,t.velocity,!0),o("tau",["f, n","acting on the base"],c,t.force,!1)]}function Kv(n,e){if(n===null||!Number.isFinite(n+e))return[-1,1];let t=e-n,i=Math.max(Math.abs(n),Math.abs(e));return t<=1e-9*i||t<1e-12?i<1e-12?[-1,1]:[n-.5*i,e+.5*i]:[n-.06*t,e+.06*t]}function Qv(n,e,t,i){let[s,r,o]=["--ink","--line","--muted"].map(Tr),a=[...new Set(n.curves.map(({unit:h})=>h))],l="11px system-ui, sans-serif",c=(h,d,u)=>({scale:h,side:d,stroke:o,font:l,size:46,gap:3,grid:{show:u,stroke:r,width:1},ticks:{show:!1},values:(m,g)=>g.map(x=>String(Number(x.toPrecision(6))))});return{width:e,height:t,padding:[8,a.length>1?0:12,0,0],legend:{show:!1},cursor:{sync:{key:Zv},drag:{x:!1,y:!1},points:{size:6},y:!1},focus:{alpha:.3},scales:{x:{time:!1,range:()=>[i[0],i[i.length-1]||1]},...Object.fromEntries(a.map(h=>[h,{range:(d,u,m)=>Kv(u,m)}]))},axes:[{stroke:o,font:l,size:26,gap:3,grid:{stroke:r,width:1},ticks:{show:!1},values:(h,d)=>d.map(u=>`${Number(u.toPrecision(6))}`)},...a.map((h,d)=>c(h,d===0?3:1,d===0))],series:[{},...n.curves.map(({name:h,unit:d,color:u,isDashed:m})=>({label:h,scale:d,stroke:Tr(u)||s,width:1.8,dash:m?[5,4]:void 0,points:{show:!1}}))]}}function Ig(n){let{joints:e}=n,t=new Set,i=H("div",{class:"plots"}),s=H("p",{class:"status",role:"status","data-key":"status"}),r=[],o=H("div",{class:"legend",role:"group","aria-label":"Joints in the plots"},e.map((x,f)=>{let p=H("button",{type:"button",class:"chip","aria-pressed":!0});return p.style.setProperty("--color",`var(--joint-${f%8})`),p.append(H("span",{class:"dot"}),x.name),p.addEventListener("click",()=>{t.delete(f)||t.add(f),p.setAttribute("aria-pressed",!t.has(f)),r.forEach(({plot:M,chart:C,readings:y})=>M.curves.forEach(({joint:T},b)=>{T===f&&(C.setSeries(b+1,{show:!t.has(f)}),y[b].hidden=t.has(f))}))}),p})),a=H("button",{type:"button",class:"quiet","data-key":"csv"},"Save as CSV");a.addEventListener("click",()=>{let x=n.freedoms.map(M=>M.name),f=Zp(n.trajectory,x),p=H("a",{href:URL.createObjectURL(new Blob([f],{type:"text/csv"}))});p.download=`${n.table.name}.csv`,p.click(),setTimeout(()=>URL.revokeObjectURL(p.href),1e3)});function l(){let{trajectory:x}=n;if(r.forEach(({chart:p})=>p.destroy()),r=[],i.replaceChildren(),g.hidden=x===null,!x)return;d();let f=x.t.length>1;if(a.disabled=!f,!!f){for(let p of jv(n)){let[M,C]=p.title,y=[...new Set(p.curves.map(({unit:L})=>L))],T=p.curves.map(({color:L,sign:O,joint:R})=>{let U=H("span",{class:"reading"});return U.style.setProperty("--color",`var(${L})`),U.append(...O?[H("i",{},O)]:fn(M,R+1)," ",H("data")),U}),b=H("div",{class:"chart",role:"img","aria-label":`${C} over time, ${y.join(" and ")}`}),_=H("figure",{"data-plot":p.key},H("figcaption",{},H("b",{},H("i",{},M)),` ${C}, ${y.join(" and ")}`),H("div",{class:"readings"},T),b);i.append(_);let v=168,D=[x.t,...p.curves.map(({values:L})=>L)],P=new In(Qv(p,Math.max(b.clientWidth,120),v,x.t),D,b),I=H("div",{class:"playhead"});P.over.append(I),c(P),p.curves.forEach(({joint:L},O)=>{L===null||!t.has(L)||(P.setSeries(O+1,{show:!1}),T[O].hidden=!0)}),r.push({plot:p,chart:P,head:I,readings:T,canvas:b})}m(),h()}}function c(x){let f=p=>{let{left:M}=x.over.getBoundingClientRect();n.play(!1),n.setTime(x.posToVal(p.clientX-M,"x"))};x.over.addEventListener("pointerdown",p=>{x.over.setPointerCapture(p.pointerId),f(p)}),x.over.addEventListener("pointermove",p=>{x.over.hasPointerCapture(p.pointerId)&&f(p)})}function h(){let{trajectory:x,state:f}=n;if(!x||r.length===0)return;let p=n.evaluated();for(let{plot:M,chart:C,head:y,readings:T}of r)y.style.transform=`translateX(${C.valToPos(f.t,"x")}px)`,M.curves.forEach(({now:b},_)=>{let v=T[_].lastChild;v.value=String(b(p)),v.textContent=mr(b(p))})}function d(){let{trajectory:x,state:f,table:p}=n,M=[],C=x.t.length>1;if(x.ended){let{t:y,reason:T}=x.ended;M.push(C?`Ends at ${mr(y)} s: ${T}.`:`The motion cannot begin: ${T}.`)}if(f.mode==="free"&&C){let y=x.energyScale>0?x.drift/x.energyScale:0;M.push(`Integrated by DOP853. Energy and work balance to ${x.drift.toExponential(1)} J, ${y.toExponential(1)} of what is exchanged.`);let T=e.filter((b,_)=>{let{limits:v}=p.rows.find(D=>D.joint===_);return v&&x.q.some(D=>D[_]<v[0]-1e-9||D[_]>v[1]+1e-9)});T.length>0&&M.push(`Limits are no stops here: ${T.map(b=>b.name).join(", ")} passed them.`)}s.textContent=M.join(" "),s.classList.toggle("warning",!!x.ended)}let u=new ResizeObserver(()=>{for(let{chart:x,canvas:f}of r){let p=f.clientWidth;p>0&&p!==x.width&&x.setSize({width:p,height:x.height})}h()}),m=()=>r.forEach(({canvas:x})=>u.observe(x)),g=H("section",{class:"panel","aria-label":"Plots"},H("div",{class:"bar"},o,a),s,i);return n.on("trajectory units theme",()=>g.isConnected&&l()),n.on("time",h),{section:g,build:l}}var nr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ir={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},c0=0,Vd=1,h0=2;var Qa=1,u0=2,Go=3,sr=0,ti=1,rs=2,Dr=0,Ho=1,Gd=2,Hd=3,Wd=4,d0=5;var Nr=100,f0=101,p0=102,m0=103,g0=104,_0=200,x0=201,y0=202,v0=203,Xd=204,qd=205,S0=206,M0=207,b0=208,w0=209,E0=210,T0=211,A0=212,R0=213,C0=214,xc=0,yc=1,vc=2,Lo=3,Sc=4,Mc=5,bc=6,wc=7,Yd=0,P0=1,I0=2,os=0,$d=1,Zd=2,jd=3,Jd=4,Kd=5,Qd=6,ef=7;var tf=300,Ur=301,Wo=302,th=303,nh=304,Ec=1e3,is=1001,Tc=1002,_n=1003,L0=1004;var el=1005;var Kn=1006,ih=1007;var Cs=1008;var si=1009,nf=1010,sf=1011,Xo=1012,sh=1013,Gi=1014,Hi=1015,Wi=1016,rh=1017,oh=1018,Fr=1020,rf=35902,of=35899,af=1021,lf=1022,Xi=1023,Ts=1026,Ps=1027,cf=1028,ah=1029,rr=1030,lh=1031;var ch=1033,tl=33776,nl=33777,il=33778,sl=33779,hh=35840,uh=35841,dh=35842,fh=35843,ph=36196,mh=37492,gh=37496,_h=37488,xh=37489,rl=37490,yh=37491,vh=37808,Sh=37809,Mh=37810,bh=37811,wh=37812,Eh=37813,Th=37814,Ah=37815,Rh=37816,Ch=37817,Ph=37818,Ih=37819,Lh=37820,Dh=37821,Nh=36492,Uh=36494,Fh=36495,Oh=36283,Bh=36284,ol=36285,zh=36286;var wa=2300,Ac=2301,gc=2302,Nd=2303,Ud=2400,Fd=2401,Od=2402;var D0=3200;var kh=0,N0=1,Is="",Zn="srgb",Ea="srgb-linear",Ta="linear",Lt="srgb";var _c=7680;var U0=519,F0=512,O0=513,B0=514,hf=515,z0=516,k0=517,uf=518,df=519,ff=35044;var pf="300 es",Ei=2e3,Do=2001;function eS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function tS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Aa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function V0(){let n=Aa("canvas");return n.style.display="block",n}var Lg={},No=null;function Ra(...n){let e="THREE."+n.shift();No?No("log",e,...n):console.log(e,...n)}function G0(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function je(...n){n=G0(n);let e="THREE."+n.shift();if(No)No("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function it(...n){n=G0(n);let e="THREE."+n.shift();if(No)No("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Sa(...n){let e=n.join(" ");e in Lg||(Lg[e]=!0,je(...n))}function H0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var W0={[xc]:xc,[vc]:bc,[Sc]:Sc,[Lo]:Mc,[yc]:yc,[bc]:vc,[wc]:wc,[Mc]:Lo},zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Dg=1234567,Ma=Math.PI/180,Uo=180/Math.PI;function or(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function mf(n,e){return(n%e+e)%e}function nS(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function iS(n,e,t){return n!==e?(t-n)/(e-n):0}function ba(n,e,t){return(1-t)*n+t*e}function sS(n,e,t,i){return ba(n,e,1-Math.exp(-t*i))}function rS(n,e=1){return e-Math.abs(mf(n,e*2)-e)}function oS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function aS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function lS(n,e){return n+Math.floor(Math.random()*(e-n+1))}function cS(n,e){return n+Math.random()*(e-n)}function hS(n){return n*(.5-Math.random())}function uS(n){n!==void 0&&(Dg=n);let e=Dg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function dS(n){return n*Ma}function fS(n){return n*Uo}function pS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function mS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function gf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function gS(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),h=o((e+i)/2),d=r((e-i)/2),u=o((e-i)/2),m=r((i-e)/2),g=o((i-e)/2);switch(s){case"XYX":n.set(a*h,l*d,l*u,a*c);break;case"YZY":n.set(l*u,a*h,l*d,a*c);break;case"ZXZ":n.set(l*d,l*u,a*h,a*c);break;case"XZX":n.set(a*h,l*g,l*m,a*c);break;case"YXY":n.set(l*m,a*h,l*g,a*c);break;case"ZYZ":n.set(l*g,l*m,a*h,a*c);break;default:je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Vh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function _f(n,e){if(e.constructor===Float32Array)return n;let t=Vh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function xf(n,e){if(e.constructor===Float32Array)return n;let t=Vh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var al={DEG2RAD:Ma,RAD2DEG:Uo,generateUUID:or,clamp:ct,euclideanModulo:mf,mapLinear:nS,inverseLerp:iS,lerp:ba,damp:sS,pingpong:rS,smoothstep:oS,smootherstep:aS,randInt:lS,randFloat:cS,randFloatSpread:hS,seededRandom:uS,degToRad:dS,radToDeg:fS,isPowerOfTwo:pS,ceilPowerOfTwo:mS,floorPowerOfTwo:gf,setQuaternionFromProperEuler:gS,normalize:xf,denormalize:_f},bf=class bf{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};bf.prototype.isVector2=!0;var Ke=bf,Qn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],d=i[s+3],u=r[o+0],m=r[o+1],g=r[o+2],x=r[o+3];if(d!==x||l!==u||c!==m||h!==g){let f=l*u+c*m+h*g+d*x;f<0&&(u=-u,m=-m,g=-g,x=-x,f=-f);let p=1-a;if(f<.9995){let M=Math.acos(f),C=Math.sin(M);p=Math.sin(p*M)/C,a=Math.sin(a*M)/C,l=l*p+u*a,c=c*p+m*a,h=h*p+g*a,d=d*p+x*a}else{l=l*p+u*a,c=c*p+m*a,h=h*p+g*a,d=d*p+x*a;let M=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=M,c*=M,h*=M,d*=M}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],d=r[o],u=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+h*d+l*m-c*u,e[t+1]=l*g+h*u+c*d-a*m,e[t+2]=c*g+h*m+a*u-l*d,e[t+3]=h*g-a*d-l*u-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),d=a(r/2),u=l(i/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d-u*m*g;break;case"YXZ":this._x=u*h*d+c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d+u*m*g;break;case"ZXY":this._x=u*h*d-c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d-u*m*g;break;case"ZYX":this._x=u*h*d-c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d+u*m*g;break;case"YZX":this._x=u*h*d+c*m*g,this._y=c*m*d+u*h*g,this._z=c*h*g-u*m*d,this._w=c*h*d-u*m*g;break;case"XZY":this._x=u*h*d-c*m*g,this._y=c*m*d-u*h*g,this._z=c*h*g+u*m*d,this._w=c*h*d+u*m*g;break;default:je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=i+a+d;if(u>0){let m=.5/Math.sqrt(u+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(i>a&&i>d){let m=2*Math.sqrt(1+i-a-d);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>d){let m=2*Math.sqrt(1+a-i-d);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+d-i-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},wf=class wf{constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Ng.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Ng.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),h=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*h,this.y=i+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return dd.copy(this).projectOnVector(e),this.sub(dd)}reflect(e){return this.sub(dd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};wf.prototype.isVector3=!0;var q=wf,dd=new q,Ng=new Qn,Ef=class Ef{constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],d=i[7],u=i[2],m=i[5],g=i[8],x=s[0],f=s[3],p=s[6],M=s[1],C=s[4],y=s[7],T=s[2],b=s[5],_=s[8];return r[0]=o*x+a*M+l*T,r[3]=o*f+a*C+l*b,r[6]=o*p+a*y+l*_,r[1]=c*x+h*M+d*T,r[4]=c*f+h*C+d*b,r[7]=c*p+h*y+d*_,r[2]=u*x+m*M+g*T,r[5]=u*f+m*C+g*b,r[8]=u*p+m*y+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=h*o-a*c,u=a*l-h*r,m=c*r-o*l,g=t*d+i*u+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return e[0]=d*x,e[1]=(s*c-h*i)*x,e[2]=(a*i-s*o)*x,e[3]=u*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=m*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Sa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(fd.makeScale(e,t)),this}rotate(e){return Sa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(fd.makeRotation(-e)),this}translate(e,t){return Sa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(fd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}};Ef.prototype.isMatrix3=!0;var rt=Ef,fd=new rt,Ug=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Fg=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _S(){let n={enabled:!0,workingColorSpace:Ea,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Lt&&(s.r=Es(s.r),s.g=Es(s.g),s.b=Es(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Lt&&(s.r=Io(s.r),s.g=Io(s.g),s.b=Io(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Is?Ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ea]:{primaries:e,whitePoint:i,transfer:Ta,toXYZ:Ug,fromXYZ:Fg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Zn},outputColorSpaceConfig:{drawingBufferColorSpace:Zn}},[Zn]:{primaries:e,whitePoint:i,transfer:Lt,toXYZ:Ug,fromXYZ:Fg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Zn}}}),n}var St=_S();function Es(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Io(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var go,Rc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{go===void 0&&(go=Aa("canvas")),go.width=e.width,go.height=e.height;let s=go.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=go}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Aa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Es(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Es(t[i]/255)*255):t[i]=Es(t[i]);return{data:t,width:e.width,height:e.height}}else return je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},xS=0,Fo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:xS++}),this.uuid=or(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(pd(s[o].image)):r.push(pd(s[o]))}else r=pd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function pd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Rc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(je("Texture: Unable to serialize Texture."),{})}var yS=0,md=new q,ei=class n extends zi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=is,s=is,r=Kn,o=Cs,a=Xi,l=si,c=n.DEFAULT_ANISOTROPY,h=Is){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:yS++}),this.uuid=or(),this.name="",this.source=new Fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(md).x}get height(){return this.source.getSize(md).y}get depth(){return this.source.getSize(md).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==tf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ec:e.x=e.x-Math.floor(e.x);break;case is:e.x=e.x<0?0:1;break;case Tc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ec:e.y=e.y-Math.floor(e.y);break;case is:e.y=e.y<0?0:1;break;case Tc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=tf;ei.DEFAULT_ANISOTROPY=1;var Tf=class Tf{constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],m=l[5],g=l[9],x=l[2],f=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-x)<.01&&Math.abs(g-f)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+x)<.1&&Math.abs(g+f)<.1&&Math.abs(c+m+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,y=(m+1)/2,T=(p+1)/2,b=(h+u)/4,_=(d+x)/4,v=(g+f)/4;return C>y&&C>T?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=b/i,r=_/i):y>T?y<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),i=b/s,r=v/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=_/r,s=v/r),this.set(i,s,r,t),this}let M=Math.sqrt((f-g)*(f-g)+(d-x)*(d-x)+(u-h)*(u-h));return Math.abs(M)<.001&&(M=1),this.x=(f-g)/M,this.y=(d-x)/M,this.z=(u-h)/M,this.w=Math.acos((c+m+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};Tf.prototype.isVector4=!0;var Dt=Tf,Cc=class extends zi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Dt(0,0,e,t),this.scissorTest=!1,this.viewport=new Dt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Fo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},_i=class extends Cc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ca=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Pc=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var eh=class eh{constructor(e,t,i,s,r,o,a,l,c,h,d,u,m,g,x,f){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,h,d,u,m,g,x,f)}set(e,t,i,s,r,o,a,l,c,h,d,u,m,g,x,f){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=m,p[7]=g,p[11]=x,p[15]=f,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new eh().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/_o.setFromMatrixColumn(e,0).length(),r=1/_o.setFromMatrixColumn(e,1).length(),o=1/_o.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=o*h,m=o*d,g=a*h,x=a*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=m+g*c,t[5]=u-x*c,t[9]=-a*l,t[2]=x-u*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,m=l*d,g=c*h,x=c*d;t[0]=u+x*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*d,t[5]=o*h,t[9]=-a,t[2]=m*a-g,t[6]=x+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,m=l*d,g=c*h,x=c*d;t[0]=u-x*a,t[4]=-o*d,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*h,t[9]=x-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,m=o*d,g=a*h,x=a*d;t[0]=l*h,t[4]=g*c-m,t[8]=u*c+x,t[1]=l*d,t[5]=x*c+u,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,m=o*c,g=a*l,x=a*c;t[0]=l*h,t[4]=x-u*d,t[8]=g*d+m,t[1]=d,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=m*d+g,t[10]=u-x*d}else if(e.order==="XZY"){let u=o*l,m=o*c,g=a*l,x=a*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+x,t[5]=o*h,t[9]=m*d-g,t[2]=g*d-m,t[6]=a*h,t[10]=x*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(vS,e,SS)}lookAt(e,t,i){let s=this.elements;return pi.subVectors(e,t),pi.lengthSq()===0&&(pi.z=1),pi.normalize(),Ws.crossVectors(i,pi),Ws.lengthSq()===0&&(Math.abs(i.z)===1?pi.x+=1e-4:pi.z+=1e-4,pi.normalize(),Ws.crossVectors(i,pi)),Ws.normalize(),Yl.crossVectors(pi,Ws),s[0]=Ws.x,s[4]=Yl.x,s[8]=pi.x,s[1]=Ws.y,s[5]=Yl.y,s[9]=pi.y,s[2]=Ws.z,s[6]=Yl.z,s[10]=pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],d=i[5],u=i[9],m=i[13],g=i[2],x=i[6],f=i[10],p=i[14],M=i[3],C=i[7],y=i[11],T=i[15],b=s[0],_=s[4],v=s[8],D=s[12],P=s[1],I=s[5],L=s[9],O=s[13],R=s[2],U=s[6],k=s[10],z=s[14],$=s[3],X=s[7],Z=s[11],te=s[15];return r[0]=o*b+a*P+l*R+c*$,r[4]=o*_+a*I+l*U+c*X,r[8]=o*v+a*L+l*k+c*Z,r[12]=o*D+a*O+l*z+c*te,r[1]=h*b+d*P+u*R+m*$,r[5]=h*_+d*I+u*U+m*X,r[9]=h*v+d*L+u*k+m*Z,r[13]=h*D+d*O+u*z+m*te,r[2]=g*b+x*P+f*R+p*$,r[6]=g*_+x*I+f*U+p*X,r[10]=g*v+x*L+f*k+p*Z,r[14]=g*D+x*O+f*z+p*te,r[3]=M*b+C*P+y*R+T*$,r[7]=M*_+C*I+y*U+T*X,r[11]=M*v+C*L+y*k+T*Z,r[15]=M*D+C*O+y*z+T*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],m=e[14],g=e[3],x=e[7],f=e[11],p=e[15],M=l*m-c*u,C=a*m-c*d,y=a*u-l*d,T=o*m-c*h,b=o*u-l*h,_=o*d-a*h;return t*(x*M-f*C+p*y)-i*(g*M-f*T+p*b)+s*(g*C-x*T+p*_)-r*(g*y-x*b+f*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],m=e[11],g=e[12],x=e[13],f=e[14],p=e[15],M=t*a-i*o,C=t*l-s*o,y=t*c-r*o,T=i*l-s*a,b=i*c-r*a,_=s*c-r*l,v=h*x-d*g,D=h*f-u*g,P=h*p-m*g,I=d*f-u*x,L=d*p-m*x,O=u*p-m*f,R=M*O-C*L+y*I+T*P-b*D+_*v;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let U=1/R;return e[0]=(a*O-l*L+c*I)*U,e[1]=(s*L-i*O-r*I)*U,e[2]=(x*_-f*b+p*T)*U,e[3]=(u*b-d*_-m*T)*U,e[4]=(l*P-o*O-c*D)*U,e[5]=(t*O-s*P+r*D)*U,e[6]=(f*y-g*_-p*C)*U,e[7]=(h*_-u*y+m*C)*U,e[8]=(o*L-a*P+c*v)*U,e[9]=(i*P-t*L-r*v)*U,e[10]=(g*b-x*y+p*M)*U,e[11]=(d*y-h*b-m*M)*U,e[12]=(a*D-o*I-l*v)*U,e[13]=(t*I-i*D+s*v)*U,e[14]=(x*C-g*T-f*M)*U,e[15]=(h*T-d*C+u*M)*U,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,d=a+a,u=r*c,m=r*h,g=r*d,x=o*h,f=o*d,p=a*d,M=l*c,C=l*h,y=l*d,T=i.x,b=i.y,_=i.z;return s[0]=(1-(x+p))*T,s[1]=(m+y)*T,s[2]=(g-C)*T,s[3]=0,s[4]=(m-y)*b,s[5]=(1-(u+p))*b,s[6]=(f+M)*b,s[7]=0,s[8]=(g+C)*_,s[9]=(f-M)*_,s[10]=(1-(u+x))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=_o.set(s[0],s[1],s[2]).length(),a=_o.set(s[4],s[5],s[6]).length(),l=_o.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ui.copy(this);let c=1/o,h=1/a,d=1/l;return Ui.elements[0]*=c,Ui.elements[1]*=c,Ui.elements[2]*=c,Ui.elements[4]*=h,Ui.elements[5]*=h,Ui.elements[6]*=h,Ui.elements[8]*=d,Ui.elements[9]*=d,Ui.elements[10]*=d,t.setFromRotationMatrix(Ui),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ei,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(i-s),u=(t+e)/(t-e),m=(i+s)/(i-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===Ei)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Do)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ei,l=!1){let c=this.elements,h=2/(t-e),d=2/(i-s),u=-(t+e)/(t-e),m=-(i+s)/(i-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===Ei)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===Do)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}};eh.prototype.isMatrix4=!0;var Ot=eh,_o=new q,Ui=new Ot,vS=new q(0,0,0),SS=new q(1,1,1),Ws=new q,Yl=new q,pi=new q,Og=new Ot,Bg=new Qn,As=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Og.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Og,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Bg.setFromEuler(this),this.setFromQuaternion(Bg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};As.DEFAULT_ORDER="XYZ";var Pa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},MS=0,zg=new q,xo=new Qn,vs=new Ot,$l=new q,ga=new q,bS=new q,wS=new Qn,kg=new q(1,0,0),Vg=new q(0,1,0),Gg=new q(0,0,1),Hg={type:"added"},ES={type:"removed"},yo={type:"childadded",child:null},gd={type:"childremoved",child:null},Ln=class n extends zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:MS++}),this.uuid=or(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new q,t=new As,i=new Qn,s=new q(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ot},normalMatrix:{value:new rt}}),this.matrix=new Ot,this.matrixWorld=new Ot,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Pa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return xo.setFromAxisAngle(e,t),this.quaternion.multiply(xo),this}rotateOnWorldAxis(e,t){return xo.setFromAxisAngle(e,t),this.quaternion.premultiply(xo),this}rotateX(e){return this.rotateOnAxis(kg,e)}rotateY(e){return this.rotateOnAxis(Vg,e)}rotateZ(e){return this.rotateOnAxis(Gg,e)}translateOnAxis(e,t){return zg.copy(e).applyQuaternion(this.quaternion),this.position.add(zg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(kg,e)}translateY(e){return this.translateOnAxis(Vg,e)}translateZ(e){return this.translateOnAxis(Gg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(vs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?$l.copy(e):$l.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ga.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?vs.lookAt(ga,$l,this.up):vs.lookAt($l,ga,this.up),this.quaternion.setFromRotationMatrix(vs),s&&(vs.extractRotation(s.matrixWorld),xo.setFromRotationMatrix(vs),this.quaternion.premultiply(xo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Hg),yo.child=e,this.dispatchEvent(yo),yo.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(ES),gd.child=e,this.dispatchEvent(gd),gd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),vs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),vs.multiply(e.parent.matrixWorld)),e.applyMatrix4(vs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Hg),yo.child=e,this.dispatchEvent(yo),yo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ga,e,bS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ga,wS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),d=o(e.shapes),u=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),m.length>0&&(i.animations=m),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ln.DEFAULT_UP=new q(0,1,0);Ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Jn=class extends Ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},TS={type:"move"},Oo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let f=t.getJointPose(x,i),p=this._getHandJoint(c,x);f!==null&&(p.matrix.fromArray(f.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=f.radius),p.visible=f!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),m=.02,g=.005;c.inputState.pinching&&u>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(TS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Jn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},X0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Xs={h:0,s:0,l:0},Zl={h:0,s:0,l:0};function _d(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ht=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Zn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=St.workingColorSpace){if(e=mf(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=_d(o,r,e+1/3),this.g=_d(o,r,e),this.b=_d(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=Zn){function i(r){r!==void 0&&parseFloat(r)<1&&je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Zn){let i=X0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Es(e.r),this.g=Es(e.g),this.b=Es(e.b),this}copyLinearToSRGB(e){return this.r=Io(e.r),this.g=Io(e.g),this.b=Io(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Zn){return St.workingToColorSpace(zn.copy(this),e),Math.round(ct(zn.r*255,0,255))*65536+Math.round(ct(zn.g*255,0,255))*256+Math.round(ct(zn.b*255,0,255))}getHexString(e=Zn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(zn.copy(this),t);let i=zn.r,s=zn.g,r=zn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=Zn){St.workingToColorSpace(zn.copy(this),e);let t=zn.r,i=zn.g,s=zn.b;return e!==Zn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Xs),this.setHSL(Xs.h+e,Xs.s+t,Xs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Xs),e.getHSL(Zl);let i=ba(Xs.h,Zl.h,t),s=ba(Xs.s,Zl.s,t),r=ba(Xs.l,Zl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new ht;ht.NAMES=X0;var Ia=class extends Ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new As,this.environmentIntensity=1,this.environmentRotation=new As,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Fi=new q,Ss=new q,xd=new q,Ms=new q,vo=new q,So=new q,Wg=new q,yd=new q,vd=new q,Sd=new q,Md=new Dt,bd=new Dt,wd=new Dt,Zs=class n{constructor(e=new q,t=new q,i=new q){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Fi.subVectors(e,t),s.cross(Fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Fi.subVectors(s,t),Ss.subVectors(i,t),xd.subVectors(e,t);let o=Fi.dot(Fi),a=Fi.dot(Ss),l=Fi.dot(xd),c=Ss.dot(Ss),h=Ss.dot(xd),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,m=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-m-g,g,m)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ms)===null?!1:Ms.x>=0&&Ms.y>=0&&Ms.x+Ms.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ms.x),l.addScaledVector(o,Ms.y),l.addScaledVector(a,Ms.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Md.setScalar(0),bd.setScalar(0),wd.setScalar(0),Md.fromBufferAttribute(e,t),bd.fromBufferAttribute(e,i),wd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Md,r.x),o.addScaledVector(bd,r.y),o.addScaledVector(wd,r.z),o}static isFrontFacing(e,t,i,s){return Fi.subVectors(i,t),Ss.subVectors(e,t),Fi.cross(Ss).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Fi.subVectors(this.c,this.b),Ss.subVectors(this.a,this.b),Fi.cross(Ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;vo.subVectors(s,i),So.subVectors(r,i),yd.subVectors(e,i);let l=vo.dot(yd),c=So.dot(yd);if(l<=0&&c<=0)return t.copy(i);vd.subVectors(e,s);let h=vo.dot(vd),d=So.dot(vd);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(vo,o);Sd.subVectors(e,r);let m=vo.dot(Sd),g=So.dot(Sd);if(g>=0&&m<=g)return t.copy(r);let x=m*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(So,a);let f=h*g-m*d;if(f<=0&&d-h>=0&&m-g>=0)return Wg.subVectors(r,s),a=(d-h)/(d-h+(m-g)),t.copy(s).addScaledVector(Wg,a);let p=1/(f+x+u);return o=x*p,a=u*p,t.copy(i).addScaledVector(vo,o).addScaledVector(So,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},xi=class{constructor(e=new q(1/0,1/0,1/0),t=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Oi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Oi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Oi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Oi):Oi.fromBufferAttribute(r,o),Oi.applyMatrix4(e.matrixWorld),this.expandByPoint(Oi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),jl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),jl.copy(i.boundingBox)),jl.applyMatrix4(e.matrixWorld),this.union(jl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Oi),Oi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(_a),Jl.subVectors(this.max,_a),Mo.subVectors(e.a,_a),bo.subVectors(e.b,_a),wo.subVectors(e.c,_a),qs.subVectors(bo,Mo),Ys.subVectors(wo,bo),Ar.subVectors(Mo,wo);let t=[0,-qs.z,qs.y,0,-Ys.z,Ys.y,0,-Ar.z,Ar.y,qs.z,0,-qs.x,Ys.z,0,-Ys.x,Ar.z,0,-Ar.x,-qs.y,qs.x,0,-Ys.y,Ys.x,0,-Ar.y,Ar.x,0];return!Ed(t,Mo,bo,wo,Jl)||(t=[1,0,0,0,1,0,0,0,1],!Ed(t,Mo,bo,wo,Jl))?!1:(Kl.crossVectors(qs,Ys),t=[Kl.x,Kl.y,Kl.z],Ed(t,Mo,bo,wo,Jl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Oi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Oi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(bs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},bs=[new q,new q,new q,new q,new q,new q,new q,new q],Oi=new q,jl=new xi,Mo=new q,bo=new q,wo=new q,qs=new q,Ys=new q,Ar=new q,_a=new q,Jl=new q,Kl=new q,Rr=new q;function Ed(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Rr.fromArray(n,r);let a=s.x*Math.abs(Rr.x)+s.y*Math.abs(Rr.y)+s.z*Math.abs(Rr.z),l=e.dot(Rr),c=t.dot(Rr),h=i.dot(Rr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var gn=new q,Ql=new Ke,AS=0,Bi=class extends zi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:AS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=ff,this.updateRanges=[],this.gpuType=Hi,this.version=0,this._normalizationScale=e!==void 0?Vh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Ql.fromBufferAttribute(this,t),Ql.applyMatrix3(e),this.setXY(t,Ql.x,Ql.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):_f(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):xf(e,this.array)}};var La=class extends Bi{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Da=class extends Bi{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ht=class extends Bi{constructor(e,t,i){super(new Float32Array(e),t,i)}},RS=new xi,xa=new q,Td=new q,ki=class{constructor(e=new q,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):RS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;xa.subVectors(e,this.center);let t=xa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(xa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Td.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(xa.copy(e.center).add(Td)),this.expandByPoint(xa.copy(e.center).sub(Td))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},CS=0,wi=new Ot,Ad=new Ln,Eo=new q,mi=new xi,ya=new xi,Cn=new q,ii=class n extends zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:CS++}),this.uuid=or(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(eS(e)?Da:La)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return wi.makeRotationFromQuaternion(e),this.applyMatrix4(wi),this}rotateX(e){return wi.makeRotationX(e),this.applyMatrix4(wi),this}rotateY(e){return wi.makeRotationY(e),this.applyMatrix4(wi),this}rotateZ(e){return wi.makeRotationZ(e),this.applyMatrix4(wi),this}translate(e,t,i){return wi.makeTranslation(e,t,i),this.applyMatrix4(wi),this}scale(e,t,i){return wi.makeScale(e,t,i),this.applyMatrix4(wi),this}lookAt(e){return Ad.lookAt(e),Ad.updateMatrix(),this.applyMatrix4(Ad.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Eo).negate(),this.translate(Eo.x,Eo.y,Eo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ht(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];mi.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,mi.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,mi.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(mi.min),this.boundingBox.expandByPoint(mi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ki);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(e){let i=this.boundingSphere.center;if(mi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ya.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(mi.min,ya.min),mi.expandByPoint(Cn),Cn.addVectors(mi.max,ya.max),mi.expandByPoint(Cn)):(mi.expandByPoint(ya.min),mi.expandByPoint(ya.max))}mi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Cn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Cn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Cn.fromBufferAttribute(a,c),l&&(Eo.fromBufferAttribute(e,c),Cn.add(Eo)),s=Math.max(s,i.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Bi(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new q,l[D]=new q;let h=new q,d=new q,u=new q,m=new Ke,g=new Ke,x=new Ke,f=new q,p=new q;function M(D,P,I){c[D]=c[P]=c[I]=1,h.fromBufferAttribute(i,D),d.fromBufferAttribute(i,P),u.fromBufferAttribute(i,I),m.fromBufferAttribute(r,D),g.fromBufferAttribute(r,P),x.fromBufferAttribute(r,I),d.sub(h),u.sub(h),g.sub(m),x.sub(m);let L=1/(g.x*x.y-x.x*g.y);isFinite(L)&&(f.copy(d).multiplyScalar(x.y).addScaledVector(u,-g.y).multiplyScalar(L),p.copy(u).multiplyScalar(g.x).addScaledVector(d,-x.x).multiplyScalar(L),a[D].add(f),a[P].add(f),a[I].add(f),l[D].add(p),l[P].add(p),l[I].add(p))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let D=0,P=C.length;D<P;++D){let I=C[D],L=I.start,O=I.count;for(let R=L,U=L+O;R<U;R+=3)M(e.getX(R+0),e.getX(R+1),e.getX(R+2))}let y=new q,T=new q,b=new q,_=new q;function v(D){b.fromBufferAttribute(s,D),_.copy(b);let P=a[D];y.copy(P),y.sub(b.multiplyScalar(b.dot(P))).normalize(),T.crossVectors(_,P);let L=T.dot(l[D])<0?-1:1;o.setXYZW(D,y.x,y.y,y.z,L)}for(let D=0,P=i.count;D<P;++D)c[D]&&v(D);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Bi(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let u=0,m=i.count;u<m;u++)i.setXYZ(u,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,h=new q,d=new q;if(e)for(let u=0,m=e.count;u<m;u+=3){let g=e.getX(u+0),x=e.getX(u+1),f=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,f),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,f),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(f,c.x,c.y,c.z)}else for(let u=0,m=t.count;u<m;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Cn.fromBufferAttribute(e,t),Cn.normalize(),e.setXYZ(t,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),m=0,g=0;for(let x=0,f=l.length;x<f;x++){a.isInterleavedBufferAttribute?m=l[x]*a.data.stride+a.offset:m=l[x]*h;for(let p=0;p<h;p++)u[g++]=c[m++]}return new Bi(u,h,d)}if(this.index===null)return je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],m=e(u,i);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let m=c[d];h.push(m.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,m=d.length;u<m;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ic=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=ff,this.updateRanges=[],this.version=0,this.uuid=or()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Xg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Xg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Xg(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=or()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var $n=new q,Vi=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?Vh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.applyMatrix4(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.applyNormalMatrix(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.transformDirection(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Ra("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Bi(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ra("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):_f(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):xf(e,this.data.array)}},Rd=new q,PS=new q,IS=new rt,gi=class{constructor(e=new q(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Rd.subVectors(i,t).cross(PS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Rd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||IS.getNormalMatrix(e),s=this.coplanarPoint(Rd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},LS=0,ss=class extends zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:LS++}),this.uuid=or(),this.name="",this.type="Material",this.blending=Ho,this.side=sr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xd,this.blendDst=qd,this.blendEquation=Nr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=Lo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=U0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=_c,this.stencilZFail=_c,this.stencilZPass=_c,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new gi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ws=new q,Cd=new q,ec=new q,tc=new q,Ir=class{constructor(e=new q,t=new q(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ws)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ws.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ws.copy(this.origin).addScaledVector(this.direction,t),ws.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Cd.copy(e).add(t).multiplyScalar(.5),ec.copy(t).sub(e).normalize(),tc.copy(this.origin).sub(Cd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(ec),a=tc.dot(this.direction),l=-tc.dot(ec),c=tc.lengthSq(),h=Math.abs(1-o*o),d,u,m,g;if(h>0)if(d=o*l-a,u=o*a-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let x=1/h;d*=x,u*=x,m=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),m=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),m=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),m=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),m=-d*d+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Cd).addScaledVector(ec,u),m}intersectSphere(e,t){if(e.radius<0)return null;ws.subVectors(e.center,this.origin);let i=ws.dot(this.direction),s=ws.dot(ws)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(i=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(i=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(a=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ws)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=e.x-o.x,u=e.y-o.y,m=e.z-o.z,g=t.x-o.x,x=t.y-o.y,f=t.z-o.z,p=i.x-o.x,M=i.y-o.y,C=i.z-o.z,y=Math.abs(l),T=Math.abs(c),b=Math.abs(h),_,v,D,P,I,L,O,R,U,k,z,$;if(y>=T&&y>=b?(D=l,L=d,U=g,$=p,l>=0?(_=c,v=h,P=u,I=m,O=x,R=f,k=M,z=C):(_=h,v=c,P=m,I=u,O=f,R=x,k=C,z=M)):T>=b?(D=c,L=u,U=x,$=M,c>=0?(_=h,v=l,P=m,I=d,O=f,R=g,k=C,z=p):(_=l,v=h,P=d,I=m,O=g,R=f,k=p,z=C)):(D=h,L=m,U=f,$=C,h>=0?(_=l,v=c,P=d,I=u,O=g,R=x,k=p,z=M):(_=c,v=l,P=u,I=d,O=x,R=g,k=M,z=p)),D===0)return null;let X=_/D,Z=v/D,te=1/D,oe=P-X*L,ce=I-Z*L,Q=O-X*U,me=R-Z*U,_e=k-X*$,ae=z-Z*$,de=_e*me-ae*Q,Ne=oe*ae-ce*_e,Ye=Q*ce-me*oe;if(s){if(de<0||Ne<0||Ye<0)return null}else if((de<0||Ne<0||Ye<0)&&(de>0||Ne>0||Ye>0))return null;let Be=de+Ne+Ye;if(Be===0)return null;let st=te*(de*L+Ne*U+Ye*$);return(Be>0?st<0:st>0)?null:this.at(st/Be,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Lc=class extends ss{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new As,this.combine=Yd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},qg=new Ot,Cr=new Ir,nc=new ki,Yg=new q,ic=new q,sc=new q,rc=new q,Pd=new q,oc=new q,$g=new q,ac=new q,kn=class extends Ln{constructor(e=new ii,t=new Lc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){oc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Pd.fromBufferAttribute(d,e),o?oc.addScaledVector(Pd,h):oc.addScaledVector(Pd.sub(t),h))}t.add(oc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),nc.copy(i.boundingSphere),nc.applyMatrix4(r),Cr.copy(e.ray).recast(e.near),!(nc.containsPoint(Cr.origin)===!1&&(Cr.intersectSphere(nc,Yg)===null||Cr.origin.distanceToSquared(Yg)>(e.far-e.near)**2))&&(qg.copy(r).invert(),Cr.copy(e.ray).applyMatrix4(qg),!(i.boundingBox!==null&&Cr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Cr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let f=u[g],p=o[f.materialIndex],M=Math.max(f.start,m.start),C=Math.min(a.count,Math.min(f.start+f.count,m.start+m.count));for(let y=M,T=C;y<T;y+=3){let b=a.getX(y),_=a.getX(y+1),v=a.getX(y+2);s=lc(this,p,e,i,c,h,d,b,_,v),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),x=Math.min(a.count,m.start+m.count);for(let f=g,p=x;f<p;f+=3){let M=a.getX(f),C=a.getX(f+1),y=a.getX(f+2);s=lc(this,o,e,i,c,h,d,M,C,y),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=u.length;g<x;g++){let f=u[g],p=o[f.materialIndex],M=Math.max(f.start,m.start),C=Math.min(l.count,Math.min(f.start+f.count,m.start+m.count));for(let y=M,T=C;y<T;y+=3){let b=y,_=y+1,v=y+2;s=lc(this,p,e,i,c,h,d,b,_,v),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),x=Math.min(l.count,m.start+m.count);for(let f=g,p=x;f<p;f+=3){let M=f,C=f+1,y=f+2;s=lc(this,o,e,i,c,h,d,M,C,y),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}}};function DS(n,e,t,i,s,r,o,a){let l;if(e.side===ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===sr,a),l===null)return null;ac.copy(a),ac.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(ac);return c<t.near||c>t.far?null:{distance:c,point:ac.clone(),object:n}}function lc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,ic),n.getVertexPosition(l,sc),n.getVertexPosition(c,rc);let h=DS(n,e,t,i,ic,sc,rc,$g);if(h){let d=new q;Zs.getBarycoord($g,ic,sc,rc,d),s&&(h.uv=Zs.getInterpolatedAttribute(s,a,l,c,d,new Ke)),r&&(h.uv1=Zs.getInterpolatedAttribute(r,a,l,c,d,new Ke)),o&&(h.normal=Zs.getInterpolatedAttribute(o,a,l,c,d,new q),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new q,materialIndex:0};Zs.getNormal(ic,sc,rc,u.normal),h.face=u,h.barycoord=d}return h}var Dc=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=_n,h=_n,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pr=new ki,NS=new Ke(.5,.5),cc=new q,js=class{constructor(e=new gi,t=new gi,i=new gi,s=new gi,r=new gi,o=new gi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ei,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],m=r[7],g=r[8],x=r[9],f=r[10],p=r[11],M=r[12],C=r[13],y=r[14],T=r[15];if(s[0].setComponents(c-o,m-h,p-g,T-M).normalize(),s[1].setComponents(c+o,m+h,p+g,T+M).normalize(),s[2].setComponents(c+a,m+d,p+x,T+C).normalize(),s[3].setComponents(c-a,m-d,p-x,T-C).normalize(),i)s[4].setComponents(l,u,f,y).normalize(),s[5].setComponents(c-l,m-u,p-f,T-y).normalize();else if(s[4].setComponents(c-l,m-u,p-f,T-y).normalize(),t===Ei)s[5].setComponents(c+l,m+u,p+f,T+y).normalize();else if(t===Do)s[5].setComponents(l,u,f,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Pr)}intersectsSprite(e){Pr.center.set(0,0,0);let t=NS.distanceTo(e.center);return Pr.radius=.7071067811865476+t,Pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Pr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(cc.x=s.normal.x>0?e.max.x:e.min.x,cc.y=s.normal.y>0?e.max.y:e.min.y,cc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(cc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Zg=new Ot,Nc=class n{constructor(){this.coordinateSystem=Ei,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Zg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new js),i[s].setFromProjectionMatrix(Zg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new js),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Na=class extends ss{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Uc=new q,Fc=new q,jg=new Ot,va=new Ir,hc=new ki,Id=new q,Jg=new q,Oc=class extends Ln{constructor(e=new ii,t=new Na){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Uc.fromBufferAttribute(t,s-1),Fc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Uc.distanceTo(Fc);e.setAttribute("lineDistance",new Ht(i,1))}else je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),hc.copy(i.boundingSphere),hc.applyMatrix4(s),hc.radius+=r,e.ray.intersectsSphere(hc)===!1)return;jg.copy(s).invert(),va.copy(e.ray).applyMatrix4(jg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let m=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=m,f=g-1;x<f;x+=c){let p=h.getX(x),M=h.getX(x+1),C=uc(this,e,va,l,p,M,x);C&&t.push(C)}if(this.isLineLoop){let x=h.getX(g-1),f=h.getX(m),p=uc(this,e,va,l,x,f,g-1);p&&t.push(p)}}else{let m=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let x=m,f=g-1;x<f;x+=c){let p=uc(this,e,va,l,x,x+1,x);p&&t.push(p)}if(this.isLineLoop){let x=uc(this,e,va,l,g-1,m,g-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function uc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Uc.fromBufferAttribute(a,s),Fc.fromBufferAttribute(a,r),t.distanceSqToSegment(Uc,Fc,Id,Jg)>i)return;Id.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Id);if(!(c<e.near||c>e.far))return{distance:c,point:Jg.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Kg=new q,Qg=new q,Bc=class extends Oc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Kg.fromBufferAttribute(t,s),Qg.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Kg.distanceTo(Qg);e.setAttribute("lineDistance",new Ht(i,1))}else je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ua=class extends ei{constructor(e=[],t=Ur,i,s,r,o,a,l,c,h){super(e,t,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Fa=class extends ei{constructor(e,t,i,s,r,o,a,l,c){super(e,t,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Rs=class extends ei{constructor(e,t,i=Gi,s,r,o,a=_n,l=_n,c,h=Ts,d=1){if(h!==Ts&&h!==Ps)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Oa=class extends Rs{constructor(e,t=Gi,i=Ur,s,r,o=_n,a=_n,l,c=Ts){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ba=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Js=class n extends ii{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,m=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ht(c,3)),this.setAttribute("normal",new Ht(h,3)),this.setAttribute("uv",new Ht(d,2));function g(x,f,p,M,C,y,T,b,_,v,D){let P=y/_,I=T/v,L=y/2,O=T/2,R=b/2,U=_+1,k=v+1,z=0,$=0,X=new q;for(let Z=0;Z<k;Z++){let te=Z*I-O;for(let oe=0;oe<U;oe++){let ce=oe*P-L;X[x]=ce*M,X[f]=te*C,X[p]=R,c.push(X.x,X.y,X.z),X[x]=0,X[f]=0,X[p]=b>0?1:-1,h.push(X.x,X.y,X.z),d.push(oe/_),d.push(1-Z/v),z+=1}}for(let Z=0;Z<v;Z++)for(let te=0;te<_;te++){let oe=u+te+U*Z,ce=u+te+U*(Z+1),Q=u+(te+1)+U*(Z+1),me=u+(te+1)+U*Z;l.push(oe,ce,me),l.push(ce,Q,me),$+=6}a.addGroup(m,$,D),m+=$,u+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Bo=class n extends ii{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],m=[],g=0,x=[],f=i/2,p=0;M(),o===!1&&(e>0&&C(!0),t>0&&C(!1)),this.setIndex(h),this.setAttribute("position",new Ht(d,3)),this.setAttribute("normal",new Ht(u,3)),this.setAttribute("uv",new Ht(m,2));function M(){let y=new q,T=new q,b=0,_=(t-e)/i;for(let v=0;v<=r;v++){let D=[],P=v/r,I=P*(t-e)+e;for(let L=0;L<=s;L++){let O=L/s,R=O*l+a,U=Math.sin(R),k=Math.cos(R);T.x=I*U,T.y=-P*i+f,T.z=I*k,d.push(T.x,T.y,T.z),y.set(U,_,k).normalize(),u.push(y.x,y.y,y.z),m.push(O,1-P),D.push(g++)}x.push(D)}for(let v=0;v<s;v++)for(let D=0;D<r;D++){let P=x[D][v],I=x[D+1][v],L=x[D+1][v+1],O=x[D][v+1];(e>0||D!==0)&&(h.push(P,I,O),b+=3),(t>0||D!==r-1)&&(h.push(I,L,O),b+=3)}c.addGroup(p,b,0),p+=b}function C(y){let T=g,b=new Ke,_=new q,v=0,D=y===!0?e:t,P=y===!0?1:-1;for(let L=1;L<=s;L++)d.push(0,f*P,0),u.push(0,P,0),m.push(.5,.5),g++;let I=g;for(let L=0;L<=s;L++){let R=L/s*l+a,U=Math.cos(R),k=Math.sin(R);_.x=D*k,_.y=f*P,_.z=D*U,d.push(_.x,_.y,_.z),u.push(0,P,0),b.x=U*.5+.5,b.y=k*.5*P+.5,m.push(b.x,b.y),g++}for(let L=0;L<s;L++){let O=T+L,R=I+L;y===!0?h.push(R,R+1,O):h.push(R+1,R,O),v+=3}c.addGroup(p,v,y===!0?1:2),p+=v}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},za=class n extends Bo{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Lr=class n extends ii{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,d=e/a,u=t/l,m=[],g=[],x=[],f=[];for(let p=0;p<h;p++){let M=p*u-o;for(let C=0;C<c;C++){let y=C*d-r;g.push(y,-M,0),x.push(0,0,1),f.push(C/a),f.push(1-p/l)}}for(let p=0;p<l;p++)for(let M=0;M<a;M++){let C=M+c*p,y=M+c*(p+1),T=M+1+c*(p+1),b=M+1+c*p;m.push(C,y,b),m.push(y,T,b)}this.setIndex(m),this.setAttribute("position",new Ht(g,3)),this.setAttribute("normal",new Ht(x,3)),this.setAttribute("uv",new Ht(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ka=class n extends ii{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new q,u=new q,m=[],g=[],x=[],f=[];for(let p=0;p<=i;p++){let M=[],C=p/i,y=o+C*a,T=e*Math.cos(y),b=Math.sqrt(e*e-T*T),_=0;p===0&&o===0?_=.5/t:p===i&&l===Math.PI&&(_=-.5/t);for(let v=0;v<=t;v++){let D=v/t,P=s+D*r;d.x=-b*Math.cos(P),d.y=T,d.z=b*Math.sin(P),g.push(d.x,d.y,d.z),u.copy(d).normalize(),x.push(u.x,u.y,u.z),f.push(D+_,1-C),M.push(c++)}h.push(M)}for(let p=0;p<i;p++)for(let M=0;M<t;M++){let C=h[p][M+1],y=h[p][M],T=h[p+1][M],b=h[p+1][M+1];(p!==0||o>0)&&m.push(C,y,b),(p!==i-1||l<Math.PI)&&m.push(y,T,b)}this.setIndex(m),this.setAttribute("position",new Ht(g,3)),this.setAttribute("normal",new Ht(x,3)),this.setAttribute("uv",new Ht(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Va=class extends ii{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new q,r=new q;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let d=l[c],u=d.start,m=d.count;for(let g=u,x=u+m;g<x;g+=3)for(let f=0;f<3;f++){let p=a.getX(g+f),M=a.getX(g+(f+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,M),e0(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,d=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,d),e0(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ht(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function e0(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}var Ga=class extends ss{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new ht(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function Or(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(t0(s))s.isRenderTargetTexture?(je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(t0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=Or(n[t]);for(let s in i)e[s]=i[s]}return e}function t0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function US(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function yf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var ll={clone:Or,merge:Vn},FS=`void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,OS=`void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ti=class extends ss{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=FS,this.fragmentShader=OS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Or(e.uniforms),this.uniformsGroups=US(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ht().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[i].value=new q().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Dt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Ot().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},zc=class extends Ti{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},zo=class extends ss{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=kh,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new As,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var kc=class extends ss{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=D0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Vc=class extends ss{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function To(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function dc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ks=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Gc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ud,endingEnd:Ud}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Fd:r=e,a=2*t-i;break;case Od:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Fd:o=e,l=2*i-t;break;case Od:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,m=this._weightNext,g=(i-t)/(s-t),x=g*g,f=x*g,p=-u*f+2*u*x-u*g,M=(1+u)*f+(-1.5-2*u)*x+(-.5+u)*g+1,C=(-1-m)*f+(1.5+m)*x+.5*g,y=m*f-m*x;for(let T=0;T!==a;++T)r[T]=p*o[h+T]+M*o[c+T]+C*o[l+T]+y*o[d+T];return r}},Hc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(i-t)/(s-t),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Wc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Xc=class extends Ks{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(i-t)/(s-t),x=1-g;for(let f=0;f!==a;++f)r[f]=o[c+f]*x+o[l+f]*g;return r}let u=a*2,m=e-1;for(let g=0;g!==a;++g){let x=o[c+g],f=o[l+g],p=m*u+g*2,M=d[p],C=d[p+1],y=e*u+g*2,T=h[y],b=h[y+1],_=zS(i,t,M,T,s);r[g]=q0(_,x,C,b,f)}return r}};function q0(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function BS(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function zS(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=q0(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=BS(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var yi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=To(t,this.TimeBufferType),this.values=To(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:To(e.times,Array),values:To(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),dc(e.settings)&&(i.settings={inTangents:To(e.settings.inTangents,Array),outTangents:To(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Wc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Hc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Gc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Xc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case wa:t=this.InterpolantFactoryMethodDiscrete;break;case Ac:t=this.InterpolantFactoryMethodLinear;break;case gc:t=this.InterpolantFactoryMethodSmooth;break;case Nd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return wa;case this.InterpolantFactoryMethodLinear:return Ac;case this.InterpolantFactoryMethodSmooth:return gc;case this.InterpolantFactoryMethodBezier:return Nd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;dc(this.settings)&&(n0(this.settings.inTangents,e),n0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;dc(this.settings)&&(i0(this.settings.inTangents,e),i0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&tS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===gc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,u=d-i,m=d+i;for(let g=0;g!==i;++g){let x=t[d+g];if(x!==t[u+g]||x!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,u=o*i;for(let m=0;m!==i;++m)t[u+m]=t[d+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,dc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function n0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function i0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}yi.prototype.ValueTypeName="";yi.prototype.TimeBufferType=Float32Array;yi.prototype.ValueBufferType=Float32Array;yi.prototype.DefaultInterpolation=Ac;var Qs=class extends yi{constructor(e,t,i){super(e,t,i)}};Qs.prototype.ValueTypeName="bool";Qs.prototype.ValueBufferType=Array;Qs.prototype.DefaultInterpolation=wa;Qs.prototype.InterpolantFactoryMethodLinear=void 0;Qs.prototype.InterpolantFactoryMethodSmooth=void 0;var qc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};qc.prototype.ValueTypeName="color";var Yc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Yc.prototype.ValueTypeName="number";var $c=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Qn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ha=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new $c(this.times,this.values,this.getValueSize(),e)}};Ha.prototype.ValueTypeName="quaternion";Ha.prototype.InterpolantFactoryMethodSmooth=void 0;var er=class extends yi{constructor(e,t,i){super(e,t,i)}};er.prototype.ValueTypeName="string";er.prototype.ValueBufferType=Array;er.prototype.DefaultInterpolation=wa;er.prototype.InterpolantFactoryMethodLinear=void 0;er.prototype.InterpolantFactoryMethodSmooth=void 0;var Zc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Zc.prototype.ValueTypeName="vector";var jc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let m=c[d],g=c[d+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Y0=new jc,Jc=class{constructor(e){this.manager=e!==void 0?e:Y0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Jc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Wa=class extends Ln{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Xa=class extends Wa{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ht(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Ld=new Ot,s0=new q,r0=new q,Kc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new Ot,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new js,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Dt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;s0.setFromMatrixPosition(e.matrixWorld),t.position.copy(s0),r0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(r0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Ld.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Ld,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Do||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Ld)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},fc=new q,pc=new Qn,ns=new q,qa=class extends Ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ot,this.projectionMatrix=new Ot,this.projectionMatrixInverse=new Ot,this.coordinateSystem=Ei,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(fc,pc,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fc,pc,ns.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(fc,pc,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fc,pc,ns.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},$s=new q,o0=new Ke,a0=new Ke,jn=class extends qa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Uo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ma*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Uo*2*Math.atan(Math.tan(Ma*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){$s.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set($s.x,$s.y).multiplyScalar(-e/$s.z),$s.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set($s.x,$s.y).multiplyScalar(-e/$s.z)}getViewSize(e,t){return this.getViewBounds(e,o0,a0),t.subVectors(a0,o0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ma*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ya=class extends qa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Bd=class extends Kc{constructor(){super(new Ya(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},$a=class extends Wa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.target=new Ln,this.shadow=new Bd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Za=class extends ii{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ao=-90,Ro=1,ko=class extends Ln{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(Ao,Ro,e,t);s.layers=this.layers,this.add(s);let r=new jn(Ao,Ro,e,t);r.layers=this.layers,this.add(r);let o=new jn(Ao,Ro,e,t);o.layers=this.layers,this.add(o);let a=new jn(Ao,Ro,e,t);a.layers=this.layers,this.add(a);let l=new jn(Ao,Ro,e,t);l.layers=this.layers,this.add(l);let c=new jn(Ao,Ro,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ei)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Do)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let f=!1;e.isWebGLRenderer===!0?f=e.state.buffers.depth.getReversed():f=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,m),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Qc=class extends jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var vf="\\[\\]\\.:\\/",kS=new RegExp("["+vf+"]","g"),Sf="[^"+vf+"]",VS="[^"+vf.replace("\\.","")+"]",GS=/((?:WC+[\/:])*)/.source.replace("WC",Sf),HS=/(WCOD+)?/.source.replace("WCOD",VS),WS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Sf),XS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Sf),qS=new RegExp("^"+GS+HS+WS+XS+"$"),YS=["material","materials","bones","map"],zd=class{constructor(e,t,i){let s=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(kS,"")}static parseTrackName(e){let t=qS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);YS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=zd;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var aR=new Float32Array(1);var tr=class extends Ic{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var Vo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ct(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ct(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Af=class Af{constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};Af.prototype.isMatrix2=!0;var kd=Af;var l0=new q,mc=new q,Co=new q,Po=new q,Dd=new q,$S=new q,ZS=new q,ja=class{constructor(e=new q,t=new q){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){l0.subVectors(e,this.start),mc.subVectors(this.end,this.start);let i=mc.dot(mc);if(i===0)return 0;let r=mc.dot(l0)/i;return t&&(r=ct(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=$S,i=ZS){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,h=e.end;Co.subVectors(c,a),Po.subVectors(h,l),Dd.subVectors(a,l);let d=Co.dot(Co),u=Po.dot(Po),m=Po.dot(Dd);if(d<=s&&u<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(d<=s)r=0,o=m/u,o=ct(o,0,1);else{let g=Co.dot(Dd);if(u<=s)o=0,r=ct(-g/d,0,1);else{let x=Co.dot(Po),f=d*u-x*x;f!==0?r=ct((x*m-g*u)/f,0,1):r=0,o=(x*r+m)/u,o<0?(o=0,r=ct(-g/d,0,1)):o>1&&(o=1,r=ct((x-g)/d,0,1))}}return t.copy(a).addScaledVector(Co,r),i.copy(l).addScaledVector(Po,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Ja=class extends Bc{constructor(e=10,t=10,i=4473924,s=8947848){i=new ht(i),s=new ht(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let u=0,m=0,g=-a;u<=t;u++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let x=u===r?i:s;x.toArray(c,m),m+=3,x.toArray(c,m),m+=3,x.toArray(c,m),m+=3,x.toArray(c,m),m+=3}let h=new ii;h.setAttribute("position",new Ht(l,3)),h.setAttribute("color",new Ht(c,3));let d=new Na({vertexColors:!0,toneMapped:!1});super(h,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ka=class extends zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Mf(n,e,t,i){let s=jS(i);switch(t){case af:return n*e;case cf:return n*e/s.components*s.byteLength;case ah:return n*e/s.components*s.byteLength;case rr:return n*e*2/s.components*s.byteLength;case lh:return n*e*2/s.components*s.byteLength;case lf:return n*e*3/s.components*s.byteLength;case Xi:return n*e*4/s.components*s.byteLength;case ch:return n*e*4/s.components*s.byteLength;case tl:case nl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case il:case sl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case uh:case fh:return Math.max(n,16)*Math.max(e,8)/4;case hh:case dh:return Math.max(n,8)*Math.max(e,8)/2;case ph:case mh:case _h:case xh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case gh:case rl:case yh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case vh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Mh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case bh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case wh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Eh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Th:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ah:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Rh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ch:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ph:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Ih:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Lh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Dh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Nh:case Uh:case Fh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Oh:case Bh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ol:case zh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function jS(n){switch(n){case si:case nf:return{byteLength:1,components:1};case Xo:case sf:case Wi:return{byteLength:2,components:1};case rh:case oh:return{byteLength:2,components:4};case Gi:case sh:case Hi:return{byteLength:4,components:1};case rf:case of:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function m_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function KS(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=n.SHORT;else if(c instanceof Uint32Array)m=n.UNSIGNED_INT;else if(c instanceof Int32Array)m=n.INT;else if(c instanceof Int8Array)m=n.BYTE;else if(c instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,h);else{d.sort((m,g)=>m.start-g.start);let u=0;for(let m=1;m<d.length;m++){let g=d[u],x=d[m];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++u,d[u]=x)}d.length=u+1;for(let m=0,g=d.length;m<g;m++){let x=d[m];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var QS=`#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,eM=`#ifdef USE_ALPHAHASH
const float ALPHA_HASH_SCALE = 0.05;
float hash2D( vec2 value ) {
return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
}
float hash3D( vec3 value ) {
return hash2D( vec2( hash2D( value.xy ), value.z ) );
}
float getAlphaHashThreshold( vec3 position ) {
float maxDeriv = max(
length( dFdx( position.xyz ) ),
length( dFdy( position.xyz ) )
);
float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
vec2 pixScales = vec2(
exp2( floor( log2( pixScale ) ) ),
exp2( ceil( log2( pixScale ) ) )
);
vec2 alpha = vec2(
hash3D( floor( pixScales.x * position.xyz ) ),
hash3D( floor( pixScales.y * position.xyz ) )
);
float lerpFactor = fract( log2( pixScale ) );
float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
float a = min( lerpFactor, 1.0 - lerpFactor );
vec3 cases = vec3(
x * x / ( 2.0 * a * ( 1.0 - a ) ),
( x - 0.5 * a ) / ( 1.0 - a ),
1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
);
float threshold = ( x < ( 1.0 - a ) )
? ( ( x < a ) ? cases.x : cases.y )
: cases.z;
return clamp( threshold , 1.0e-6, 1.0 );
}
#endif`,tM=`#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,nM=`#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif`,iM=`#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif`,sM=`#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif`,rM=`#ifdef USE_AOMAP
float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
reflectedLight.indirectDiffuse *= ambientOcclusion;
#if defined( USE_CLEARCOAT ) 
clearcoatSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_SHEEN ) 
sheenSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_ENVMAP ) && defined( STANDARD )
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
#endif
#endif`,oM=`#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif`,aM=`#ifdef USE_BATCHING
#if ! defined( GL_ANGLE_multi_draw )
#define gl_DrawID _gl_DrawID
uniform int _gl_DrawID;
#endif
uniform highp sampler2D batchingTexture;
uniform highp usampler2D batchingIdTexture;
mat4 getBatchingMatrix( const in float i ) {
int size = textureSize( batchingTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
float getIndirectIndex( const in int i ) {
int size = textureSize( batchingIdTexture, 0 ).x;
int x = i % size;
int y = i / size;
return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
}
#endif
#ifdef USE_BATCHING_COLOR
uniform sampler2D batchingColorTexture;
vec4 getBatchingColor( const in float i ) {
int size = textureSize( batchingColorTexture, 0 ).x;
int j = int( i );
int x = j % size;
int y = j / size;
return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
}
#endif`,lM=`#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,cM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif`,hM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif`,uM=`float G_BlinnPhong_Implicit( ) {
return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( specularColor, 1.0, dotVH );
float G = G_BlinnPhong_Implicit( );
float D = D_BlinnPhong( shininess, dotNH );
return F * ( G * D );
} // validated`,dM=`#ifdef USE_IRIDESCENCE
const mat3 XYZ_TO_REC709 = mat3(
 3.2404542, -0.9692660,  0.0556434,
-1.5371385,  1.8760108, -0.2040259,
-0.4985314,  0.0415560,  1.0572252
);
vec3 Fresnel0ToIor( vec3 fresnel0 ) {
vec3 sqrtF0 = sqrt( fresnel0 );
return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
}
vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
}
float IorToFresnel0( float transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
}
vec3 evalSensitivity( float OPD, vec3 shift ) {
float phase = 2.0 * PI * OPD * 1.0e-9;
vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
xyz /= 1.0685e-7;
vec3 rgb = XYZ_TO_REC709 * xyz;
return rgb;
}
vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
vec3 I;
float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
float cosTheta2Sq = 1.0 - sinTheta2Sq;
if ( cosTheta2Sq < 0.0 ) {
return vec3( 1.0 );
}
float cosTheta2 = sqrt( cosTheta2Sq );
float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
float R12 = F_Schlick( R0, 1.0, cosTheta1 );
float T121 = 1.0 - R12;
float phi12 = 0.0;
if ( iridescenceIOR < outsideIOR ) phi12 = PI;
float phi21 = PI - phi12;
vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
vec3 phi23 = vec3( 0.0 );
if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
vec3 phi = vec3( phi21 ) + phi23;
vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
vec3 r123 = sqrt( R123 );
vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
vec3 C0 = R12 + Rs;
I = C0;
vec3 Cm = Rs - T121;
for ( int m = 1; m <= 2; ++ m ) {
Cm *= r123;
vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
I += Cm * Sm;
}
return max( I, vec3( 0.0 ) );
}
#endif`,fM=`#ifdef USE_BUMPMAP
uniform sampler2D bumpMap;
uniform float bumpScale;
vec2 dHdxy_fwd() {
vec2 dSTdx = dFdx( vBumpMapUv );
vec2 dSTdy = dFdy( vBumpMapUv );
float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
return vec2( dBx, dBy );
}
vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
vec3 vN = surf_norm;
vec3 R1 = cross( vSigmaY, vN );
vec3 R2 = cross( vN, vSigmaX );
float fDet = dot( vSigmaX, R1 ) * faceDirection;
vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
return normalize( abs( fDet ) * surf_norm - vGrad );
}
#endif`,pM=`#if NUM_CLIPPING_PLANES > 0
vec4 plane;
#ifdef ALPHA_TO_COVERAGE
float distanceToPlane, distanceGradient;
float clipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
if ( clipOpacity == 0.0 ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
float unionClipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
}
#pragma unroll_loop_end
clipOpacity *= 1.0 - unionClipOpacity;
#endif
diffuseColor.a *= clipOpacity;
if ( diffuseColor.a == 0.0 ) discard;
#else
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
bool clipped = true;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
}
#pragma unroll_loop_end
if ( clipped ) discard;
#endif
#endif
#endif`,mM=`#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,gM=`#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif`,_M=`#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif`,xM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif`,yM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif`,vM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif`,SM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
vColor *= color;
#elif defined( USE_COLOR )
vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,MM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
const highp float a = 12.9898, b = 78.233, c = 43758.5453;
highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
float precisionSafeLength( vec3 v ) { return length( v ); }
#else
float precisionSafeLength( vec3 v ) {
float maxComponent = max3( abs( v ) );
return length( v / maxComponent ) * maxComponent;
}
#endif
struct IncidentLight {
vec3 color;
vec3 direction;
bool visible;
};
struct ReflectedLight {
vec3 directDiffuse;
vec3 directSpecular;
vec3 indirectDiffuse;
vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,bM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
mat3 bm = mat3( batchingMatrix );
transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
transformedNormal = bm * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = bm * transformedTangent;
#endif
#endif
#ifdef USE_INSTANCING
mat3 im = mat3( instanceMatrix );
transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
transformedNormal = im * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = im * transformedTangent;
#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,wM=`#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif`,EM=`#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,TM=`#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,AM=`#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif`,RM="gl_FragColor = linearToOutputTexel( gl_FragColor );",CM=`vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,PM=`#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vec3 cameraToFrag;
if ( isOrthographic ) {
cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToFrag = normalize( vWorldPosition - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vec3 reflectVec = reflect( cameraToFrag, worldNormal );
#else
vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
#endif
#else
vec3 reflectVec = vReflect;
#endif
#ifdef ENVMAP_TYPE_CUBE
vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
#ifdef ENVMAP_BLENDING_MULTIPLY
outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_MIX )
outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_ADD )
outgoingLight += envColor.xyz * specularStrength * reflectivity;
#endif
#endif
#endif`,IM=`#ifdef USE_ENVMAP
uniform float envMapIntensity;
uniform mat3 envMapRotation;
uniform samplerCube envMap;
#ifdef ENVMAP_TYPE_PMREM
float roughnessToMip( const in float roughness ) {
float r = clamp( roughness, 0.0, 1.0 );
return ENVMAP_MAX_LOD * r * ( 2.0 - r );
}
#endif
#endif`,LM=`#ifdef USE_ENVMAP
uniform float reflectivity;
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
uniform float refractionRatio;
#else
varying vec3 vReflect;
#endif
#endif`,DM=`#ifdef USE_ENVMAP
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS

varying vec3 vWorldPosition;
#else
varying vec3 vReflect;
uniform float refractionRatio;
#endif
#endif`,NM=`#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vWorldPosition = worldPosition.xyz;
#else
vec3 cameraToVertex;
if ( isOrthographic ) {
cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vReflect = reflect( cameraToVertex, worldNormal );
#else
vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
#endif
#endif
#endif`,UM=`#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif`,FM=`#ifdef USE_FOG
varying float vFogDepth;
#endif`,OM=`#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,BM=`#ifdef USE_FOG
uniform vec3 fogColor;
varying float vFogDepth;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif`,zM=`#ifdef USE_GRADIENTMAP
uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
float dotNL = dot( normal, lightDirection );
vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
#ifdef USE_GRADIENTMAP
return vec3( texture2D( gradientMap, coord ).r );
#else
vec2 fw = fwidth( coord ) * 0.5;
return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
#endif
}`,kM=`#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif`,VM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,GM=`varying vec3 vViewPosition;
struct LambertMaterial {
vec3 diffuseColor;
float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,HM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
float x = normal.x, y = normal.y, z = normal.z;
vec3 result = shCoefficients[ 0 ] * 0.886227;
result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
vec3 irradiance = ambientLightColor;
return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
if ( cutoffDistance > 0.0 ) {
distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
}
return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
struct SunLight {
vec3 direction;
vec3 color;
};
uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
light.color = sunLight.color;
light.direction = sunLight.direction;
light.visible = true;
}
#endif
#if NUM_DIR_LIGHTS > 0
struct DirectionalLight {
vec3 direction;
vec3 color;
};
uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
light.color = directionalLight.color;
light.direction = directionalLight.direction;
light.visible = true;
}
#endif
#if NUM_POINT_LIGHTS > 0
struct PointLight {
vec3 position;
vec3 color;
float distance;
float decay;
};
uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = pointLight.position - geometryPosition;
light.direction = normalize( lVector );
float lightDistance = length( lVector );
light.color = pointLight.color;
light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
}
#endif
#if NUM_SPOT_LIGHTS > 0
struct SpotLight {
vec3 position;
vec3 direction;
vec3 color;
float distance;
float decay;
float coneCos;
float penumbraCos;
};
uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = spotLight.position - geometryPosition;
light.direction = normalize( lVector );
float angleCos = dot( light.direction, spotLight.direction );
float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
if ( spotAttenuation > 0.0 ) {
float lightDistance = length( lVector );
light.color = spotLight.color * spotAttenuation;
light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
} else {
light.color = vec3( 0.0 );
light.visible = false;
}
}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
struct RectAreaLight {
vec3 color;
vec3 position;
vec3 halfWidth;
vec3 halfHeight;
};
uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
struct HemisphereLight {
vec3 direction;
vec3 skyColor;
vec3 groundColor;
};
uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
float dotNL = dot( normal, hemiLight.direction );
float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
return irradiance;
}
#endif
#include <lightprobes_pars_fragment>`,WM=`#ifdef USE_ENVMAP
vec3 getIBLIrradiance( const in vec3 normal ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
return PI * envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 reflectVec = reflect( - viewDir, normal );
reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#endif
#ifdef USE_ANISOTROPY
vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRetroRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#endif
#endif
#endif`,XM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,qM=`varying vec3 vViewPosition;
struct ToonMaterial {
vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,YM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,$M=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
vec3 diffuseColor;
vec3 specularColor;
float specularShininess;
float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,ZM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughnessFactor = diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
#endif
material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
material.ior = ior;
#ifdef USE_SPECULAR
float specularIntensityFactor = specularIntensity;
vec3 specularColorFactor = specularColor;
#ifdef USE_SPECULAR_COLORMAP
specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
#endif
material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
#else
float specularIntensityFactor = 1.0;
vec3 specularColorFactor = vec3( 1.0 );
material.specularF90 = 1.0;
#endif
material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
material.specularColor = vec3( 0.04 );
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
material.clearcoat = clearcoat;
material.clearcoatRoughness = clearcoatRoughness;
material.clearcoatF0 = vec3( 0.04 );
material.clearcoatF90 = 1.0;
#ifdef USE_CLEARCOATMAP
material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
#endif
material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
material.clearcoatRoughness += geometryRoughness;
material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
material.iridescence = iridescence;
material.iridescenceIOR = iridescenceIOR;
#ifdef USE_IRIDESCENCEMAP
material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
#else
material.iridescenceThickness = iridescenceThicknessMaximum;
#endif
#endif
#ifdef USE_SHEEN
material.sheenColor = sheenColor;
#ifdef USE_SHEEN_COLORMAP
material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
#endif
material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
#ifdef USE_SHEEN_ROUGHNESSMAP
material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
#endif
#endif
#ifdef USE_ANISOTROPY
#ifdef USE_ANISOTROPYMAP
mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
#else
vec2 anisotropyV = anisotropyVector;
#endif
material.anisotropy = length( anisotropyV );
if( material.anisotropy == 0.0 ) {
anisotropyV = vec2( 1.0, 0.0 );
} else {
anisotropyV /= material.anisotropy;
material.anisotropy = saturate( material.anisotropy );
}
material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,jM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
vec3 diffuseColor;
vec3 diffuseContribution;
vec3 specularColor;
vec3 specularColorBlended;
float roughness;
float metalness;
float specularF90;
float dispersion;
vec2 dfg;
vec3 multiScatteringCompensation;
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughness;
#endif
#ifdef USE_RETROREFLECTION
float retroreflectivity;
#endif
#ifdef USE_CLEARCOAT
float clearcoat;
float clearcoatRoughness;
vec3 clearcoatF0;
float clearcoatF90;
#endif
#ifdef USE_IRIDESCENCE
float iridescence;
float iridescenceIOR;
float iridescenceThickness;
vec3 iridescenceFresnel;
vec3 iridescenceF0Dielectric;
vec3 iridescenceF0Metallic;
#endif
#ifdef USE_SHEEN
vec3 sheenColor;
float sheenRoughness;
#endif
#ifdef IOR
float ior;
#endif
#ifdef USE_TRANSMISSION
float transmission;
float transmissionAlpha;
float thickness;
float attenuationDistance;
vec3 attenuationColor;
#endif
#ifdef USE_ANISOTROPY
float anisotropy;
float alphaT;
vec3 anisotropyT;
vec3 anisotropyB;
#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
const float EON_EPSILON = 1e-7;
float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
float muComp = 1.0 - mu;
float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
return A * ( 1.0 + roughness * gOverPi );
}
vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float s = dot( lightDir, viewDir ) - dotNL * dotNV;
float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
* max( EON_EPSILON, 1.0 - albedoV )
* max( EON_EPSILON, 1.0 - albedoL )
/ max( EON_EPSILON, 1.0 - averageAlbedo );
return singleScatter + multiScatter;
}
vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return rho;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
float a2 = pow2( alpha );
float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
float a2 = pow2( alpha );
float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
float a2 = alphaT * alphaB;
highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
highp float v2 = dot( v, v );
float w2 = a2 / v2;
return RECIPROCAL_PI * a2 * pow2 ( w2 );
}
#endif
#ifdef USE_CLEARCOAT
vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
vec3 f0 = material.clearcoatF0;
float f90 = material.clearcoatF90;
float roughness = max( material.clearcoatRoughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
return F * ( V * D );
}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
vec3 f0 = material.specularColorBlended;
float f90 = material.specularF90;
float roughness = max( material.roughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
#ifdef USE_IRIDESCENCE
F = mix( F, material.iridescenceFresnel, material.iridescence );
#endif
#ifdef USE_ANISOTROPY
float dotTL = dot( material.anisotropyT, lightDir );
float dotTV = dot( material.anisotropyT, viewDir );
float dotTH = dot( material.anisotropyT, halfDir );
float dotBL = dot( material.anisotropyB, lightDir );
float dotBV = dot( material.anisotropyB, viewDir );
float dotBH = dot( material.anisotropyB, halfDir );
float alphaT = max( material.alphaT, alpha );
float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
#else
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
#endif
return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
const float LUT_SIZE = 64.0;
const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
const float LUT_BIAS = 0.5 / LUT_SIZE;
float dotNV = saturate( dot( N, V ) );
vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
uv = uv * LUT_SCALE + LUT_BIAS;
return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
float l = length( f );
return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
float x = dot( v1, v2 );
float y = abs( x );
float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
float b = 3.4175940 + ( 4.1616724 + y ) * y;
float v = a / b;
float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
vec3 lightNormal = cross( v1, v2 );
if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
vec3 T1, T2;
T1 = normalize( V - N * dot( V, N ) );
T2 = - cross( N, T1 );
mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
vec3 coords[ 4 ];
coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
coords[ 0 ] = normalize( coords[ 0 ] );
coords[ 1 ] = normalize( coords[ 1 ] );
coords[ 2 ] = normalize( coords[ 2 ] );
coords[ 3 ] = normalize( coords[ 3 ] );
vec3 vectorFormFactor = vec3( 0.0 );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
float alpha = pow2( roughness );
float invAlpha = 1.0 / alpha;
float cos2h = dotNH * dotNH;
float sin2h = max( 1.0 - cos2h, 0.0078125 );
return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float D = D_Charlie( sheenRoughness, dotNH );
float V = V_Neubelt( dotNV, dotNL );
return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
float r2 = roughness * roughness;
float rInv = 1.0 / ( roughness + 0.1 );
float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
float DG = exp( a * dotNV + b );
return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
#ifdef USE_IRIDESCENCE
vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
#else
vec3 Fr = specularColor;
#endif
vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
float Ess = fab.x + fab.y;
float Ems = 1.0 - Ess;
vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
singleScatter += FssEss;
multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 normal = geometryNormal;
vec3 viewDir = geometryViewDir;
vec3 position = geometryPosition;
vec3 lightPos = rectAreaLight.position;
vec3 halfWidth = rectAreaLight.halfWidth;
vec3 halfHeight = rectAreaLight.halfHeight;
vec3 lightColor = rectAreaLight.color;
float roughness = material.roughness;
vec3 rectCoords[ 4 ];
rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
vec2 uv = LTC_Uv( normal, viewDir, roughness );
vec4 t1 = texture2D( ltc_1, uv );
vec4 t2 = texture2D( ltc_2, uv );
mat3 mInv = mat3(
vec3( t1.x, 0, t1.y ),
vec3(    0, 1,    0 ),
vec3( t1.z, 0, t1.w )
);
vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
#ifdef USE_CLEARCOAT
vec3 Ncc = geometryClearcoatNormal;
vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
mat3 mInvClearcoat = mat3(
vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
vec3(             0, 1,             0 ),
vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
);
vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
#endif
}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
#ifdef USE_CLEARCOAT
float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
vec3 ccIrradiance = dotNLcc * directLight.color;
clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
#endif
#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
#ifdef USE_RETROREFLECTION
vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
#endif
reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
vec3 halfDir = normalize( directLight.direction + geometryViewDir );
float dotVH = saturate( dot( geometryViewDir, halfDir ) );
vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
#ifdef USE_RETROREFLECTION
vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
F = mix( F, retroF, saturate( material.retroreflectivity ) );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
#else
vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
#endif
reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 singleScattering = vec3( 0.0 );
vec3 multiScattering = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
#else
vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
#endif
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
diffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
#ifdef USE_CLEARCOAT
clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
#endif
#ifdef USE_SHEEN
sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
vec3 singleScatteringDielectric = vec3( 0.0 );
vec3 multiScatteringDielectric = vec3( 0.0 );
vec3 singleScatteringMetallic = vec3( 0.0 );
vec3 multiScatteringMetallic = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
#endif
vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
#else
vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
#endif
vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
vec3 indirectSpecular = radiance * singleScattering;
indirectSpecular += multiScattering * cosineWeightedIrradiance;
vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
indirectSpecular *= sheenEnergyComp;
indirectDiffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectSpecular += indirectSpecular;
reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,JM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
float dotNVi = saturate( dot( normal, geometryViewDir ) );
if ( material.iridescenceThickness == 0.0 ) {
material.iridescence = 0.0;
} else {
material.iridescence = saturate( material.iridescence );
}
if ( material.iridescence > 0.0 ) {
vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
}
#endif
#ifdef STANDARD
float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
float EssMs = material.dfg.x + material.dfg.y;
material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
PointLight pointLight;
#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
PointLightShadow pointLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
pointLight = pointLights[ i ];
getPointLightInfo( pointLight, geometryPosition, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
pointLightShadow = pointLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
SpotLight spotLight;
vec4 spotColor;
vec3 spotLightCoord;
bool inSpotLightMap;
#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
spotLight = spotLights[ i ];
getSpotLightInfo( spotLight, geometryPosition, directLight );
#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
#else
#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#endif
#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
#endif
#undef SPOT_LIGHT_MAP_INDEX
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
spotLightShadow = spotLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
SunLight sunLight;
#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
sunLight = sunLights[ i ];
getSunLightInfo( sunLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
sunLightShadow = sunLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
DirectionalLight directionalLight;
#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
directionalLight = directionalLights[ i ];
getDirectionalLightInfo( directionalLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
directionalLightShadow = directionalLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
RectAreaLight rectAreaLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
rectAreaLight = rectAreaLights[ i ];
RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
vec3 iblIrradiance = vec3( 0.0 );
vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
#if defined( USE_LIGHT_PROBES )
irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
#endif
#if ( NUM_HEMI_LIGHTS > 0 )
#pragma unroll_loop_start
for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
}
#pragma unroll_loop_end
#endif
#if NUM_LIGHT_PROBE_GRIDS > 0
vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
int probeGrid = - 1;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
}
#pragma unroll_loop_end
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
}
#pragma unroll_loop_end
#endif
#endif
#if defined( RE_IndirectSpecular )
vec3 radiance = vec3( 0.0 );
vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,KM=`#if defined( RE_IndirectDiffuse )
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
irradiance += lightMapIrradiance;
#endif
#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
iblIrradiance += getIBLIrradiance( geometryNormal );
#endif
#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
#ifdef USE_ANISOTROPY
vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
#ifdef USE_RETROREFLECTION
#ifdef USE_ANISOTROPY
vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
#endif
radiance += iblRadiance;
#ifdef USE_CLEARCOAT
clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
#endif
#endif`,QM=`#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,eb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
vec3 spacing = ( probesMax - probesMin ) / probesResolution;
vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
vec3 margin = spacing * 0.01;
return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
vec3 res = probesResolution;
vec3 gridRange = probesMax - probesMin;
vec3 probeSpacing = gridRange / res;
vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
float nz          = res.z;
float paddedSlices = nz + 2.0;
float atlasDepth  = 7.0 * paddedSlices;
float uvZBase     = uvw.z * nz + 1.0;
vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
vec3 c0 = s0.xyz;
vec3 c1 = vec3( s0.w, s1.xy );
vec3 c2 = vec3( s1.zw, s2.x );
vec3 c3 = s2.yzw;
vec3 c4 = s3.xyz;
vec3 c5 = vec3( s3.w, s4.xy );
vec3 c6 = vec3( s4.zw, s5.x );
vec3 c7 = s5.yzw;
vec3 c8 = s6.xyz;
float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
vec3 result = c0 * 0.886227;
result += c1 * 2.0 * 0.511664 * y;
result += c2 * 2.0 * 0.511664 * z;
result += c3 * 2.0 * 0.511664 * x;
result += c4 * 2.0 * 0.429043 * x * y;
result += c5 * 2.0 * 0.429043 * y * z;
result += c6 * ( 0.743125 * z * z - 0.247708 );
result += c7 * 2.0 * 0.429043 * x * z;
result += c8 * 0.429043 * ( x * x - y * y );
return max( result, vec3( 0.0 ) );
}
#endif`,tb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,nb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif`,ib=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif`,sb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,rb=`#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif`,ob=`#ifdef USE_MAP
uniform sampler2D map;
#endif`,ab=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
#if defined( USE_POINTS_UV )
vec2 uv = vUv;
#else
vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
#endif
#endif
#ifdef USE_MAP
diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,lb=`#if defined( USE_POINTS_UV )
varying vec2 vUv;
#else
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
uniform mat3 uvTransform;
#endif
#endif
#ifdef USE_MAP
uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif`,cb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif`,hb=`#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif`,ub=`#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif`,db=`#if defined( USE_MORPHCOLORS )
#if defined( USE_COLOR_ALPHA )
vColor *= morphTargetBaseInfluence;
#elif defined( USE_COLOR )
vColor.rgb *= morphTargetBaseInfluence;
#endif
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
#if defined( USE_COLOR_ALPHA )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
#elif defined( USE_COLOR )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
#endif
}
#endif`,fb=`#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif`,pb=`#ifdef USE_MORPHTARGETS
#ifndef USE_INSTANCING_MORPH
uniform float morphTargetBaseInfluence;
uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
#endif
uniform sampler2DArray morphTargetsTexture;
uniform ivec2 morphTargetsTextureSize;
vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
int y = texelIndex / morphTargetsTextureSize.x;
int x = texelIndex - y * morphTargetsTextureSize.x;
ivec3 morphUV = ivec3( x, y, morphTargetIndex );
return texelFetch( morphTargetsTexture, morphUV, 0 );
}
#endif`,mb=`#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif`,gb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
vec3 fdx = dFdx( vViewPosition );
vec3 fdy = dFdy( vViewPosition );
vec3 normal = normalize( cross( fdx, fdy ) );
#else
vec3 normal = normalize( vNormal );
#ifdef DOUBLE_SIDED
normal *= faceDirection;
#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
#ifdef USE_TANGENT
mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn = getTangentFrame( - vViewPosition, normal,
#if defined( USE_NORMALMAP )
vNormalMapUv
#elif defined( USE_CLEARCOAT_NORMALMAP )
vClearcoatNormalMapUv
#else
vUv
#endif
);
#endif
#ifdef DOUBLE_SIDED
tbn[0] *= faceDirection;
tbn[1] *= faceDirection;
#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
#ifdef USE_TANGENT
mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
#endif
#ifdef DOUBLE_SIDED
tbn2[0] *= faceDirection;
tbn2[1] *= faceDirection;
#endif
#endif
vec3 nonPerturbedNormal = normal;`,_b=`#ifdef USE_NORMALMAP_OBJECTSPACE
normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#ifdef FLIP_SIDED
normal = - normal;
#endif
#ifdef DOUBLE_SIDED
normal = normal * faceDirection;
#endif
normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#if defined( USE_PACKED_NORMALMAP )
mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
#endif
mapN.xy *= normalScale;
normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,xb=`#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif`,yb=`#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif`,vb=`#ifndef FLAT_SHADED
vNormal = normalize( transformedNormal );
#ifdef USE_TANGENT
vTangent = normalize( transformedTangent );
vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
#ifdef FLIP_SIDED
vBitangent = - vBitangent;
#endif
#endif
#endif`,Sb=`#ifdef USE_NORMALMAP
uniform sampler2D normalMap;
uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
vec3 q0 = dFdx( eye_pos.xyz );
vec3 q1 = dFdy( eye_pos.xyz );
vec2 st0 = dFdx( uv.st );
vec2 st1 = dFdy( uv.st );
vec3 N = surf_norm;
vec3 q1perp = cross( q1, N );
vec3 q0perp = cross( N, q0 );
vec3 T = q1perp * st0.x + q0perp * st1.x;
vec3 B = q1perp * st0.y + q0perp * st1.y;
float det = max( dot( T, T ), dot( B, B ) );
float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
return mat3( T * scale, B * scale, N );
}
#endif`,Mb=`#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,bb=`#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,wb=`#ifdef USE_CLEARCOATMAP
uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform sampler2D clearcoatNormalMap;
uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform sampler2D clearcoatRoughnessMap;
#endif`,Eb=`#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif`,Tb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Ab=`vec3 packNormalToRGB( const in vec3 normal ) {
return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
if( v <= 0.0 )
return vec4( 0., 0., 0., 0. );
if( v >= 1.0 )
return vec4( 1., 1., 1., 1. );
float vuf;
float af = modf( v * PackFactors.a, vuf );
float bf = modf( vuf * ShiftRight8, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
if( v <= 0.0 )
return vec3( 0., 0., 0. );
if( v >= 1.0 )
return vec3( 1., 1., 1. );
float vuf;
float bf = modf( v * PackFactors.b, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
if( v <= 0.0 )
return vec2( 0., 0. );
if( v >= 1.0 )
return vec2( 1., 1. );
float vuf;
float gf = modf( v * 256., vuf );
return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
#ifdef USE_REVERSED_DEPTH_BUFFER

return depth * ( far - near ) - far;
#else
return depth * ( near - far ) - near;
#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {

#ifdef USE_REVERSED_DEPTH_BUFFER
return ( near * far ) / ( ( near - far ) * depth - near );
#else
return ( near * far ) / ( ( far - near ) * depth - far );
#endif
}`,Rb=`#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Cb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Pb=`#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ib=`#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif`,Lb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif`,Db=`#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif`,Nb=`#if NUM_SPOT_LIGHT_COORDS > 0
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
#define SUN_LIGHT_CASCADES 2
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#else
uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#endif
uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
struct SunLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#else
uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#endif
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#else
uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#elif defined( SHADOWMAP_TYPE_BASIC )
uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#endif
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float interleavedGradientNoise( vec2 position ) {
return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
}
vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
const float goldenAngle = 2.399963229728653;
float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
float theta = float( sampleIndex ) * goldenAngle + phi;
return vec2( cos( theta ), sin( theta ) ) * r;
}
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
vec2 radius = shadowRadius * texelSize;
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = (
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
) * 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_VSM )
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
float mean = distribution.x;
float variance = distribution.y * distribution.y;
#ifdef USE_REVERSED_DEPTH_BUFFER
float hard_shadow = step( mean, shadowCoord.z );
#else
float hard_shadow = step( shadowCoord.z, mean );
#endif

if ( hard_shadow == 1.0 ) {
shadow = 1.0;
} else {
variance = max( variance, 0.0000001 );
float d = shadowCoord.z - mean;
float p_max = variance / ( variance + d * d );
p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
shadow = max( hard_shadow, p_max );
}
}
return mix( 1.0, shadow, shadowIntensity );
}
#else
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
float depth = texture2D( shadowMap, shadowCoord.xy ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadow = step( depth, shadowCoord.z );
#else
shadow = step( shadowCoord.z, depth );
#endif
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#if NUM_SUN_LIGHT_SHADOWS > 0
float getSunShadow(
#if defined( SHADOWMAP_TYPE_PCF )
sampler2DShadow shadowMap,
#else
sampler2D shadowMap,
#endif
SunLightShadow sunLightShadow,
int shadowIndex
) {
vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
float viewDepth = vSunShadowWorldPosition.w;
int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
float shadow = 1.0;
for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
float cascadeShadow = getShadow(
shadowMap,
sunLightShadow.shadowMapSize,
sunLightShadow.shadowIntensity,
sunLightShadow.shadowBias,
sunLightShadow.shadowRadius,
sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
);
shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
}
}
return shadow;
}
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 bd3D = normalize( lightToPosition );
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float lightDistance = length( lightToPosition );
float depthRange = shadowCameraFar - shadowCameraNear;
#ifdef USE_REVERSED_DEPTH_BUFFER
float depthA = - shadowCameraNear / depthRange - shadowBias;
float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#else
float depthA = shadowCameraFar / depthRange + shadowBias;
float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#endif
float texelSize = shadowRadius / shadowMapSize.x;
vec3 absDir = abs( bd3D );
vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
tangent = normalize( cross( bd3D, tangent ) );
vec3 bitangent = cross( bd3D, tangent );
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = 0.0;
for ( int i = 0; i < 5; i ++ ) {
vec2 offset = vogelDiskSample( i, 5, phi );
vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
vec3 absDirection = abs( direction );
float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
shadow += texture( shadowMap, vec4( direction, dp ) );
}
shadow *= 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_BASIC )
float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
dp += shadowBias;
vec3 bd3D = normalize( lightToPosition );
float depth = textureCube( shadowMap, bd3D ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
depth = 1.0 - depth;
#endif
shadow = step( dp, depth );
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#endif
#endif`,Ub=`#if NUM_SPOT_LIGHT_COORDS > 0
uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#endif`,Fb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
#ifdef HAS_NORMAL
vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#else
vec3 shadowWorldNormal = vec3( 0.0 );
#endif
vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
#if NUM_SUN_LIGHT_SHADOWS > 0
vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
vSunShadowWorldNormal = shadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
shadowWorldPosition = worldPosition;
#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
#endif
vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif`,Ob=`float getShadowMask() {
float shadow = 1.0;
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
sunLight = sunLightShadows[ i ];
shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
directionalLight = directionalLightShadows[ i ];
shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
spotLight = spotLightShadows[ i ];
shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
PointLightShadow pointLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
pointLight = pointLightShadows[ i ];
shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
}
#pragma unroll_loop_end
#endif
#endif
return shadow;
}`,Bb=`#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,zb=`#ifdef USE_SKINNING
uniform mat4 bindMatrix;
uniform mat4 bindMatrixInverse;
uniform highp sampler2D boneTexture;
mat4 getBoneMatrix( const in float i ) {
int size = textureSize( boneTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
#endif`,kb=`#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Vb=`#ifdef USE_SKINNING
mat4 skinMatrix = mat4( 0.0 );
skinMatrix += skinWeight.x * boneMatX;
skinMatrix += skinWeight.y * boneMatY;
skinMatrix += skinWeight.z * boneMatZ;
skinMatrix += skinWeight.w * boneMatW;
skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
#ifdef USE_TANGENT
objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
#endif
#endif`,Gb=`float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif`,Hb=`#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif`,Wb=`#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Xb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
color *= toneMappingExposure;
return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
color *= toneMappingExposure;
color = max( vec3( 0.0 ), color - 0.004 );
return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
const mat3 ACESInputMat = mat3(
vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
vec3( 0.04823, 0.01566, 0.83777 )
);
const mat3 ACESOutputMat = mat3(
vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
vec3( -0.07367, -0.00605,  1.07602 )
);
color *= toneMappingExposure / 0.6;
color = ACESInputMat * color;
color = RRTAndODTFit( color );
color = ACESOutputMat * color;
return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
vec3( 1.6605, - 0.1246, - 0.0182 ),
vec3( - 0.5876, 1.1329, - 0.1006 ),
vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
vec3( 0.6274, 0.0691, 0.0164 ),
vec3( 0.3293, 0.9195, 0.0880 ),
vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
vec3 x2 = x * x;
vec3 x4 = x2 * x2;
return + 15.5 * x4 * x2
- 40.14 * x4 * x
+ 31.96 * x4
- 6.868 * x2 * x
+ 0.4298 * x2
+ 0.1191 * x
- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
const mat3 AgXInsetMatrix = mat3(
vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
);
const mat3 AgXOutsetMatrix = mat3(
vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
);
const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
color *= toneMappingExposure;
color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
color = AgXInsetMatrix * color;
color = max( color, 1e-10 );	color = log2( color );
color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
color = clamp( color, 0.0, 1.0 );
color = agxDefaultContrastApprox( color );
color = AgXOutsetMatrix * color;
color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
color = clamp( color, 0.0, 1.0 );
return color;
}
vec3 NeutralToneMapping( vec3 color ) {
const float StartCompression = 0.8 - 0.04;
const float Desaturation = 0.15;
color *= toneMappingExposure;
float x = min( color.r, min( color.g, color.b ) );
float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
color -= offset;
float peak = max( color.r, max( color.g, color.b ) );
if ( peak < StartCompression ) return color;
float d = 1. - StartCompression;
float newPeak = 1. - d * d / ( peak + d - StartCompression );
color *= newPeak / peak;
float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,qb=`#ifdef USE_TRANSMISSION
material.transmission = transmission;
material.transmissionAlpha = 1.0;
material.thickness = thickness;
material.attenuationDistance = attenuationDistance;
material.attenuationColor = attenuationColor;
#ifdef USE_TRANSMISSIONMAP
material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
#endif
#ifdef USE_THICKNESSMAP
material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
#endif
vec3 pos = vWorldPosition;
vec3 v = normalize( cameraPosition - pos );
vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 transmitted = getIBLVolumeRefraction(
n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
material.attenuationColor, material.attenuationDistance );
material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Yb=`#ifdef USE_TRANSMISSION
uniform float transmission;
uniform float thickness;
uniform float attenuationDistance;
uniform vec3 attenuationColor;
#ifdef USE_TRANSMISSIONMAP
uniform sampler2D transmissionMap;
#endif
#ifdef USE_THICKNESSMAP
uniform sampler2D thicknessMap;
#endif
uniform vec2 transmissionSamplerSize;
uniform sampler2D transmissionSamplerMap;
uniform mat4 modelMatrix;
uniform mat4 projectionMatrix;
varying vec3 vWorldPosition;
float w0( float a ) {
return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
}
float w1( float a ) {
return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
}
float w2( float a ){
return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
}
float w3( float a ) {
return ( 1.0 / 6.0 ) * ( a * a * a );
}
float g0( float a ) {
return w0( a ) + w1( a );
}
float g1( float a ) {
return w2( a ) + w3( a );
}
float h0( float a ) {
return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
}
float h1( float a ) {
return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
}
vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
uv = uv * texelSize.zw + 0.5;
vec2 iuv = floor( uv );
vec2 fuv = fract( uv );
float g0x = g0( fuv.x );
float g1x = g1( fuv.x );
float h0x = h0( fuv.x );
float h1x = h1( fuv.x );
float h0y = h0( fuv.y );
float h1y = h1( fuv.y );
vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
}
vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
vec2 fLodSizeInv = 1.0 / fLodSize;
vec2 cLodSizeInv = 1.0 / cLodSize;
vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
return mix( fSample, cSample, fract( lod ) );
}
vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
vec3 modelScale;
modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
return normalize( refractionVector ) * thickness * modelScale;
}
float applyIorToRoughness( const in float roughness, const in float ior ) {
return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
}
vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
}
vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
if ( isinf( attenuationDistance ) ) {
return vec3( 1.0 );
} else {
vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
}
}
vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
const in vec3 attenuationColor, const in float attenuationDistance ) {
vec4 transmittedLight;
vec3 transmittance;
#ifdef USE_DISPERSION
float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
for ( int i = 0; i < 3; i ++ ) {
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
transmittedLight[ i ] = transmissionSample[ i ];
transmittedLight.a += transmissionSample.a;
transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
}
transmittedLight.a /= 3.0;
#else
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
#endif
vec3 attenuatedColor = transmittance * transmittedLight.rgb;
vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
}
#endif`,$b=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif`,Zb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
uniform mat3 mapTransform;
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
uniform mat3 alphaMapTransform;
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
uniform mat3 lightMapTransform;
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
uniform mat3 aoMapTransform;
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
uniform mat3 bumpMapTransform;
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
uniform mat3 normalMapTransform;
varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
uniform mat3 displacementMapTransform;
varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
uniform mat3 emissiveMapTransform;
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
uniform mat3 metalnessMapTransform;
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
uniform mat3 roughnessMapTransform;
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform mat3 diffuseRoughnessMapTransform;
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
uniform mat3 anisotropyMapTransform;
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
uniform mat3 clearcoatMapTransform;
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform mat3 clearcoatNormalMapTransform;
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform mat3 clearcoatRoughnessMapTransform;
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
uniform mat3 sheenColorMapTransform;
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform mat3 sheenRoughnessMapTransform;
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
uniform mat3 iridescenceMapTransform;
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform mat3 iridescenceThicknessMapTransform;
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
uniform mat3 specularMapTransform;
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
uniform mat3 specularColorMapTransform;
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform mat3 specularIntensityMapTransform;
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif`,jb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Jb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
vec4 worldPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
worldPosition = batchingMatrix * worldPosition;
#endif
#ifdef USE_INSTANCING
worldPosition = instanceMatrix * worldPosition;
#endif
worldPosition = modelMatrix * worldPosition;
#endif`,Kb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Qb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
vec4 texColor = texture2D( t2D, vUv );
#ifdef DECODE_VIDEO_TEXTURE
texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,e1=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}`,t1=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
#ifdef ENVMAP_TYPE_PMREM
vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
#else
vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,n1=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}`,i1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
gl_FragColor = texColor;
gl_FragColor.a *= opacity;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,s1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vHighPrecisionZW = gl_Position.zw;
}`,r1=`#if DEPTH_PACKING == 3200
uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#if DEPTH_PACKING == 3200
diffuseColor.a = opacity;
#endif
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <logdepthbuf_fragment>
#ifdef USE_REVERSED_DEPTH_BUFFER
float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
#else
float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
#endif
#if DEPTH_PACKING == 3200
gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
#elif DEPTH_PACKING == 3201
gl_FragColor = packDepthToRGBA( fragCoordZ );
#elif DEPTH_PACKING == 3202
gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
#elif DEPTH_PACKING == 3203
gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
#endif
}`,o1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <worldpos_vertex>
#include <clipping_planes_vertex>
vWorldPosition = worldPosition.xyz;
}`,a1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
float dist = length( vWorldPosition - referencePosition );
dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
dist = saturate( dist );
gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,l1=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}`,c1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
vec3 direction = normalize( vWorldDirection );
vec2 sampleUV = equirectUv( direction );
gl_FragColor = texture2D( tEquirect, sampleUV );
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,h1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
vLineDistance = scale * lineDistance;
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}`,u1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
if ( mod( vLineDistance, totalSize ) > dashSize ) {
discard;
}
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,d1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <envmap_vertex>
#include <fog_vertex>
}`,f1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
#else
reflectedLight.indirectDiffuse += vec3( 1.0 );
#endif
#include <aomap_fragment>
reflectedLight.indirectDiffuse *= diffuseColor.rgb;
vec3 outgoingLight = reflectedLight.indirectDiffuse;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,p1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,m1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_lambert_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,g1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
vViewPosition = - mvPosition.xyz;
}`,_1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
vec3 viewDir = normalize( vViewPosition );
vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
vec3 y = cross( viewDir, x );
vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
#ifdef USE_MATCAP
vec4 matcapColor = texture2D( matcap, uv );
#else
vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
#endif
vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,x1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
vViewPosition = - mvPosition.xyz;
#endif
}`,y1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
#ifdef OPAQUE
gl_FragColor.a = 1.0;
#endif
}`,v1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,S1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_phong_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,M1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
#ifdef USE_TRANSMISSION
vWorldPosition = worldPosition.xyz;
#endif
}`,b1=`#define STANDARD
#ifdef PHYSICAL
#define IOR
#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
uniform float ior;
#endif
#ifdef USE_SPECULAR
uniform float specularIntensity;
uniform vec3 specularColor;
#ifdef USE_SPECULAR_COLORMAP
uniform sampler2D specularColorMap;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform sampler2D specularIntensityMap;
#endif
#endif
#ifdef USE_CLEARCOAT
uniform float clearcoat;
uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
uniform float diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform sampler2D diffuseRoughnessMap;
#endif
#endif
#ifdef USE_DISPERSION
uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
uniform float iridescence;
uniform float iridescenceIOR;
uniform float iridescenceThicknessMinimum;
uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
uniform vec3 sheenColor;
uniform float sheenRoughness;
#ifdef USE_SHEEN_COLORMAP
uniform sampler2D sheenColorMap;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform sampler2D sheenRoughnessMap;
#endif
#endif
#ifdef USE_ANISOTROPY
uniform vec2 anisotropyVector;
#ifdef USE_ANISOTROPYMAP
uniform sampler2D anisotropyMap;
#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <roughnessmap_fragment>
#include <metalnessmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <clearcoat_normal_fragment_begin>
#include <clearcoat_normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_physical_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
#include <transmission_fragment>
vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
#ifdef USE_SHEEN
 
outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
#ifdef USE_CLEARCOAT
float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
#endif
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,w1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,E1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_toon_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,T1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
varying vec2 vUv;
uniform mat3 uvTransform;
#endif
void main() {
#ifdef USE_POINTS_UV
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
#endif
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
gl_PointSize = size;
#ifdef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
#endif
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <fog_vertex>
}`,A1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_particle_fragment>
#include <color_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,R1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,C1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
#include <logdepthbuf_fragment>
gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,P1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
vec4 mvPosition = modelViewMatrix[ 3 ];
vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
#ifndef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) scale *= - mvPosition.z;
#endif
vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
vec2 rotatedPosition;
rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
mvPosition.xy += rotatedPosition;
gl_Position = projectionMatrix * mvPosition;
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}`,I1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
}`,ft={alphahash_fragment:QS,alphahash_pars_fragment:eM,alphamap_fragment:tM,alphamap_pars_fragment:nM,alphatest_fragment:iM,alphatest_pars_fragment:sM,aomap_fragment:rM,aomap_pars_fragment:oM,batching_pars_vertex:aM,batching_vertex:lM,begin_vertex:cM,beginnormal_vertex:hM,bsdfs:uM,iridescence_fragment:dM,bumpmap_pars_fragment:fM,clipping_planes_fragment:pM,clipping_planes_pars_fragment:mM,clipping_planes_pars_vertex:gM,clipping_planes_vertex:_M,color_fragment:xM,color_pars_fragment:yM,color_pars_vertex:vM,color_vertex:SM,common:MM,defaultnormal_vertex:bM,displacementmap_pars_vertex:wM,displacementmap_vertex:EM,emissivemap_fragment:TM,emissivemap_pars_fragment:AM,colorspace_fragment:RM,colorspace_pars_fragment:CM,envmap_fragment:PM,envmap_common_pars_fragment:IM,envmap_pars_fragment:LM,envmap_pars_vertex:DM,envmap_physical_pars_fragment:WM,envmap_vertex:NM,fog_vertex:UM,fog_pars_vertex:FM,fog_fragment:OM,fog_pars_fragment:BM,gradientmap_pars_fragment:zM,lightmap_pars_fragment:kM,lights_lambert_fragment:VM,lights_lambert_pars_fragment:GM,lights_pars_begin:HM,lights_toon_fragment:XM,lights_toon_pars_fragment:qM,lights_phong_fragment:YM,lights_phong_pars_fragment:$M,lights_physical_fragment:ZM,lights_physical_pars_fragment:jM,lights_fragment_begin:JM,lights_fragment_maps:KM,lights_fragment_end:QM,lightprobes_pars_fragment:eb,logdepthbuf_fragment:tb,logdepthbuf_pars_fragment:nb,logdepthbuf_pars_vertex:ib,logdepthbuf_vertex:sb,map_fragment:rb,map_pars_fragment:ob,map_particle_fragment:ab,map_particle_pars_fragment:lb,metalnessmap_fragment:cb,metalnessmap_pars_fragment:hb,morphinstance_vertex:ub,morphcolor_vertex:db,morphnormal_vertex:fb,morphtarget_pars_vertex:pb,morphtarget_vertex:mb,normal_fragment_begin:gb,normal_fragment_maps:_b,normal_pars_fragment:xb,normal_pars_vertex:yb,normal_vertex:vb,normalmap_pars_fragment:Sb,clearcoat_normal_fragment_begin:Mb,clearcoat_normal_fragment_maps:bb,clearcoat_pars_fragment:wb,iridescence_pars_fragment:Eb,opaque_fragment:Tb,packing:Ab,premultiplied_alpha_fragment:Rb,project_vertex:Cb,dithering_fragment:Pb,dithering_pars_fragment:Ib,roughnessmap_fragment:Lb,roughnessmap_pars_fragment:Db,shadowmap_pars_fragment:Nb,shadowmap_pars_vertex:Ub,shadowmap_vertex:Fb,shadowmask_pars_fragment:Ob,skinbase_vertex:Bb,skinning_pars_vertex:zb,skinning_vertex:kb,skinnormal_vertex:Vb,specularmap_fragment:Gb,specularmap_pars_fragment:Hb,tonemapping_fragment:Wb,tonemapping_pars_fragment:Xb,transmission_fragment:qb,transmission_pars_fragment:Yb,uv_pars_fragment:$b,uv_pars_vertex:Zb,uv_vertex:jb,worldpos_vertex:Jb,background_vert:Kb,background_frag:Qb,backgroundCube_vert:e1,backgroundCube_frag:t1,cube_vert:n1,cube_frag:i1,depth_vert:s1,depth_frag:r1,distance_vert:o1,distance_frag:a1,equirect_vert:l1,equirect_frag:c1,linedashed_vert:h1,linedashed_frag:u1,meshbasic_vert:d1,meshbasic_frag:f1,meshlambert_vert:p1,meshlambert_frag:m1,meshmatcap_vert:g1,meshmatcap_frag:_1,meshnormal_vert:x1,meshnormal_frag:y1,meshphong_vert:v1,meshphong_frag:S1,meshphysical_vert:M1,meshphysical_frag:b1,meshtoon_vert:w1,meshtoon_frag:E1,points_vert:T1,points_frag:A1,shadow_vert:R1,shadow_frag:C1,sprite_vert:P1,sprite_frag:I1},Ie={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},ni={basic:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Vn([Ie.common,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.roughnessmap,Ie.metalnessmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Vn([Ie.common,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.gradientmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Vn([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Vn([Ie.points,Ie.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Vn([Ie.common,Ie.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Vn([Ie.common,Ie.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Vn([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Vn([Ie.sprite,Ie.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Vn([Ie.common,Ie.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Vn([Ie.lights,Ie.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};ni.physical={uniforms:Vn([ni.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Gh={r:0,b:0,g:0},L1=new Ot,g_=new rt;g_.set(-1,0,0,0,1,0,0,0,1);function D1(n,e,t,i,s,r){let o=new ht(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function m(M){let C=M.isScene===!0?M.background:null;if(C&&C.isTexture){let y=M.backgroundBlurriness>0;C=e.get(C,y)}return C}function g(M){let C=!1,y=m(M);y===null?f(o,a):y&&y.isColor&&(f(y,1),C=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(M,C){let y=m(C);y&&y.isCubeTexture?(c===void 0&&(c=new kn(new Js(1,1,1),new Ti({name:"BackgroundCubeMaterial",uniforms:Or(ni.backgroundCube.uniforms),vertexShader:ni.backgroundCube.vertexShader,fragmentShader:ni.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,b,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(L1.makeRotationFromEuler(C.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(g_),c.material.toneMapped=St.getTransfer(y.colorSpace)!==Lt,(h!==y||d!==y.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=y,d=y.version,u=n.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new kn(new Lr(2,2),new Ti({name:"BackgroundMaterial",uniforms:Or(ni.background.uniforms),vertexShader:ni.background.vertexShader,fragmentShader:ni.background.fragmentShader,side:sr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=St.getTransfer(y.colorSpace)!==Lt,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(h!==y||d!==y.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=y,d=y.version,u=n.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function f(M,C){M.getRGB(Gh,yf(n)),t.buffers.color.setClear(Gh.r,Gh.g,Gh.b,C,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(M,C=1){o.set(M),a=C,f(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(M){a=M,f(o,a)},render:g,addToRenderList:x,dispose:p}}function N1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(I,L,O,R,U){let k=!1,z=d(I,R,O,L);r!==z&&(r=z,c(r.object)),k=m(I,R,O,U),k&&g(I,R,O,U),U!==null&&e.update(U,n.ELEMENT_ARRAY_BUFFER),(k||o)&&(o=!1,y(I,L,O,R),U!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(U).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function h(I){return n.deleteVertexArray(I)}function d(I,L,O,R){let U=R.wireframe===!0,k=i[L.id];k===void 0&&(k={},i[L.id]=k);let z=I.isInstancedMesh===!0?I.id:0,$=k[z];$===void 0&&($={},k[z]=$);let X=$[O.id];X===void 0&&(X={},$[O.id]=X);let Z=X[U];return Z===void 0&&(Z=u(l()),X[U]=Z),Z}function u(I){let L=[],O=[],R=[];for(let U=0;U<t;U++)L[U]=0,O[U]=0,R[U]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:L,enabledAttributes:O,attributeDivisors:R,object:I,attributes:{},index:null}}function m(I,L,O,R){let U=r.attributes,k=L.attributes,z=0,$=O.getAttributes();for(let X in $)if($[X].location>=0){let te=U[X],oe=k[X];if(oe===void 0&&(X==="instanceMatrix"&&I.instanceMatrix&&(oe=I.instanceMatrix),X==="instanceColor"&&I.instanceColor&&(oe=I.instanceColor)),te===void 0||te.attribute!==oe||oe&&te.data!==oe.data)return!0;z++}return r.attributesNum!==z||r.index!==R}function g(I,L,O,R){let U={},k=L.attributes,z=0,$=O.getAttributes();for(let X in $)if($[X].location>=0){let te=k[X];te===void 0&&(X==="instanceMatrix"&&I.instanceMatrix&&(te=I.instanceMatrix),X==="instanceColor"&&I.instanceColor&&(te=I.instanceColor));let oe={};oe.attribute=te,te&&te.data&&(oe.data=te.data),U[X]=oe,z++}r.attributes=U,r.attributesNum=z,r.index=R}function x(){let I=r.newAttributes;for(let L=0,O=I.length;L<O;L++)I[L]=0}function f(I){p(I,0)}function p(I,L){let O=r.newAttributes,R=r.enabledAttributes,U=r.attributeDivisors;O[I]=1,R[I]===0&&(n.enableVertexAttribArray(I),R[I]=1),U[I]!==L&&(n.vertexAttribDivisor(I,L),U[I]=L)}function M(){let I=r.newAttributes,L=r.enabledAttributes;for(let O=0,R=L.length;O<R;O++)L[O]!==I[O]&&(n.disableVertexAttribArray(O),L[O]=0)}function C(I,L,O,R,U,k,z){z===!0?n.vertexAttribIPointer(I,L,O,U,k):n.vertexAttribPointer(I,L,O,R,U,k)}function y(I,L,O,R){x();let U=R.attributes,k=O.getAttributes(),z=L.defaultAttributeValues;for(let $ in k){let X=k[$];if(X.location>=0){let Z=U[$];if(Z===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(Z=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(Z=I.instanceColor)),Z!==void 0){let te=Z.normalized,oe=Z.itemSize,ce=e.get(Z);if(ce===void 0)continue;let Q=ce.buffer,me=ce.type,_e=ce.bytesPerElement,ae=me===n.INT||me===n.UNSIGNED_INT||Z.gpuType===sh;if(Z.isInterleavedBufferAttribute){let de=Z.data,Ne=de.isInterleavedBuffer===!0?de.stride:de.itemSize,Ye=Z.offset;if(de.isInstancedInterleavedBuffer||de.isInstancedBufferAttribute){for(let Be=0;Be<X.locationSize;Be++)p(X.location+Be,de.meshPerAttribute);I.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=de.meshPerAttribute*de.count)}else for(let Be=0;Be<X.locationSize;Be++)f(X.location+Be);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Be=0;Be<X.locationSize;Be++)C(X.location+Be,oe/X.locationSize,me,te,Ne*_e,(Ye+oe/X.locationSize*Be)*_e,ae)}else{if(Z.isInstancedBufferAttribute){for(let de=0;de<X.locationSize;de++)p(X.location+de,Z.meshPerAttribute);I.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let de=0;de<X.locationSize;de++)f(X.location+de);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let de=0;de<X.locationSize;de++)C(X.location+de,oe/X.locationSize,me,te,oe*_e,oe/X.locationSize*de*_e,ae)}}else if(z!==void 0){let te=z[$];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(X.location,te);break;case 3:n.vertexAttrib3fv(X.location,te);break;case 4:n.vertexAttrib4fv(X.location,te);break;default:n.vertexAttrib1fv(X.location,te)}}}}M()}function T(){D();for(let I in i){let L=i[I];for(let O in L){let R=L[O];for(let U in R){let k=R[U];for(let z in k)h(k[z].object),delete k[z];delete R[U]}}delete i[I]}}function b(I){if(i[I.id]===void 0)return;let L=i[I.id];for(let O in L){let R=L[O];for(let U in R){let k=R[U];for(let z in k)h(k[z].object),delete k[z];delete R[U]}}delete i[I.id]}function _(I){for(let L in i){let O=i[L];for(let R in O){let U=O[R];if(U[I.id]===void 0)continue;let k=U[I.id];for(let z in k)h(k[z].object),delete k[z];delete U[I.id]}}}function v(I){for(let L in i){let O=i[L],R=I.isInstancedMesh===!0?I.id:0,U=O[R];if(U!==void 0){for(let k in U){let z=U[k];for(let $ in z)h(z[$].object),delete z[$];delete U[k]}delete O[R],Object.keys(O).length===0&&delete i[L]}}}function D(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:P,dispose:T,releaseStatesOfGeometry:b,releaseStatesOfObject:v,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:f,disableUnusedAttributes:M}}function U1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let m=0;m<h;m++)u+=c[m];t.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function F1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Xi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let v=_===Wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==si&&_!==Hi&&!v&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(je("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),f=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),M=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),b=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:m,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:f,maxAttributes:p,maxVertexUniforms:M,maxVaryings:C,maxFragmentUniforms:y,maxSamples:T,samples:b}}function O1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new gi,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let m=d.length!==0||u||i!==0||s;return s=u,i=d.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,m){let g=d.clippingPlanes,x=d.clipIntersection,f=d.clipShadows,p=n.get(d);if(!s||g===null||g.length===0||r&&!f)r?h(null):c();else{let M=r?0:i,C=M*4,y=p.clippingState||null;l.value=y,y=h(g,u,C,m);for(let T=0;T!==C;++T)y[T]=t[T];p.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(d,u,m,g){let x=d!==null?d.length:0,f=null;if(x!==0){if(f=l.value,g!==!0||f===null){let p=m+x*4,M=u.matrixWorldInverse;a.getNormalMatrix(M),(f===null||f.length<p)&&(f=new Float32Array(p));for(let C=0,y=m;C!==x;++C,y+=4)o.copy(d[C]).applyMatrix4(M,a),o.normal.toArray(f,y),f[y+3]=o.constant}l.value=f,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,f}}var ul=class extends _i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ua(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Js(5,5,5),r=new Ti({name:"CubemapFromEquirect",uniforms:Or(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ti,blending:Dr});r.uniforms.tEquirect.value=t;let o=new kn(s,r),a=t.minFilter;return t.minFilter===Cs&&(t.minFilter=Kn),new ko(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},$0=256,B1=3,z1=20,__=256,x_=16,k1=3,V1=new q,G1=new ht,Wh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ko(1,10,null),this._boxMesh=new kn(new Js(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=V1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,m=l.autoClearDepth,g=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(G1));let f=new ko(i,s,h);return f.position.copy(a),f.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=m,l.autoClearStencil=g,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=J0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=j0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max($0,gf(e))}_fromTexture(e,t){e.mapping===Ur||e.mapping===Wo?this._setSize(e.image.length===0?$0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Z0(e,!1,!1),i=Math.log2(e)-B1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Z0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ur||e.mapping===Wo?(this._cubemapMaterial===null&&(this._cubemapMaterial=J0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=j0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=H1(),this._integrationMaterial=W1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/x_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-k1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(__*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=X1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Z0(n,e,t){return new ul(n,{minFilter:Cs,generateMipmaps:e,type:Wi,colorSpace:Ea,depthBuffer:t})}function dl(n,e,t){return new Ti({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:ti,blending:Dr,depthTest:!1,depthWrite:!1})}function H1(){return dl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${__}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function W1(){return dl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:x_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function X1(){return dl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${z1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function j0(){return dl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function J0(){return dl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function q1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(u,m=!1){return u==null?null:m?o(u):r(u)}function r(u){if(u&&u.isTexture){let m=u.mapping;if(m===th||m===nh)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let x=new ul(g.height);return x.fromEquirectangularTexture(n,u),e.set(u,x),u.addEventListener("dispose",c),a(x.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let m=u.mapping,g=m===th||m===nh,x=m===Ur||m===Wo;if(g||x){let f=t.get(u),p=f!==void 0?f.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return i===null&&(i=new Wh(n)),f=g?i.fromEquirectangular(u,f):i.fromCubemap(u,f),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),f.texture;if(f!==void 0)return f.texture;{let M=u.image;return g&&M&&M.height>0||x&&M&&l(M)?(i===null&&(i=new Wh(n)),f=g?i.fromEquirectangular(u):i.fromCubemap(u),f.texture.pmremVersion=u.pmremVersion,t.set(u,f),u.addEventListener("dispose",h),f.texture):null}}}return u}function a(u,m){return m===th?u.mapping=Ur:m===nh&&(u.mapping=Wo),u}function l(u){let m=0,g=6;for(let x=0;x<g;x++)u[x]!==void 0&&m++;return m===g}function c(u){let m=u.target;m.removeEventListener("dispose",c);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function h(u){let m=u.target;m.removeEventListener("dispose",h);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function Y1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Sa("WebGLRenderer: "+i+" extension not supported."),s}}}function $1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let f in g.attributes)e.remove(g.attributes[f]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(e.remove(x),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(g){let x=g.attributes;for(let f in x)e.update(x[f],n.ARRAY_BUFFER)}function d(g){let x=g.index,f=g.attributes.position,p=0;if(f===void 0)return;let M=x!==null?x.array.length:f.array.length/3-1,C=f.count>=65535?Da:La,y=new C(Math.ceil(M/3)*6,1),T=y.array;if(x!==null){let _=x.array;p=x.version;for(let v=0,D=0;v<M;v+=3){let P=_[v+0],I=_[v+1],L=_[v+2];T[D++]=P,T[D++]=I,T[D++]=I,T[D++]=L,T[D++]=L,T[D++]=P}}else{p=f.version;for(let _=0,v=0;_<M;_+=3){let D=_+0,P=_+1,I=_+2;T[v++]=D,T[v++]=P,T[v++]=P,T[v++]=I,T[v++]=I,T[v++]=D}}y.version=p;let b=r.get(g);b&&e.remove(b),r.set(g,y)}function u(g){let x=r.get(g);if(x){let f=g.index;f!==null&&x.version<f.version&&d(g)}else d(g);return r.get(g)}function m(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:u,dispose:m}}function Z1(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){n.drawElements(i,u,r,d*o),t.update(u,i,1)}function c(d,u,m){m!==0&&(n.drawElementsInstanced(i,u,r,d*o,m),t.update(u,i,m))}function h(d,u,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,m);let x=0;for(let f=0;f<m;f++)x+=u[f];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function j1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function J1(n,e,t){let i=new WeakMap,s=new Dt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==d){let D=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",D)};u!==void 0&&u.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],C=0;m===!0&&(C=1),g===!0&&(C=2),x===!0&&(C=3);let y=a.attributes.position.count*C,T=1;y>e.maxTextureSize&&(T=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let b=new Float32Array(y*T*4*d),_=new Ca(b,y,T,d);_.type=Hi,_.needsUpdate=!0;let v=C*4;for(let P=0;P<d;P++){let I=f[P],L=p[P],O=M[P],R=y*T*4*P;for(let U=0;U<I.count;U++){let k=U*v;m===!0&&(s.fromBufferAttribute(I,U),b[R+k+0]=s.x,b[R+k+1]=s.y,b[R+k+2]=s.z,b[R+k+3]=0),g===!0&&(s.fromBufferAttribute(L,U),b[R+k+4]=s.x,b[R+k+5]=s.y,b[R+k+6]=s.z,b[R+k+7]=0),x===!0&&(s.fromBufferAttribute(O,U),b[R+k+8]=s.x,b[R+k+9]=s.y,b[R+k+10]=s.z,b[R+k+11]=O.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new Ke(y,T)},i.set(a,u),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let m=0;for(let x=0;x<c.length;x++)m+=c[x];let g=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function K1(n,e,t,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let m=c.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var Q1={[$d]:"LINEAR_TONE_MAPPING",[Zd]:"REINHARD_TONE_MAPPING",[jd]:"CINEON_TONE_MAPPING",[Jd]:"ACES_FILMIC_TONE_MAPPING",[Qd]:"AGX_TONE_MAPPING",[ef]:"NEUTRAL_TONE_MAPPING",[Kd]:"CUSTOM_TONE_MAPPING"};function ew(n,e,t,i,s,r){let o=new _i(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new ii;h.setAttribute("position",new Ht([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ht([0,2,0,0,2,0],2));let d=new zc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new kn(h,d),m=new Ya(-1,1,1,-1,0,1),g=null,x=null,f=!1,p,M=null,C=[],y=!1;this.setSize=function(T,b){o.setSize(T,b),a!==null&&a.setSize(T,b),l!==null&&l.setSize(T,b);for(let _=0;_<C.length;_++){let v=C[_];v.setSize&&v.setSize(T,b)}},this.setEffects=function(T){C=T,y=C.length>0&&C[0].isRenderPass===!0;let b=o.width,_=o.height;C.length>0&&a===null&&(a=new _i(b,_,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),l=new _i(b,_,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let v=s===!0&&C.some(D=>D.needsDepthTexture===!0);v!==(o.depthTexture!==null)&&(v===!0&&c===null&&(c=new Rs(b,_),r===!0&&(c.format=Ps,c.type=Fr)),o.dispose(),o.depthTexture=v?c:null,o.resolveDepthBuffer=v,o.storeMultisampledDepthBuffer=v);for(let D=0;D<C.length;D++){let P=C[D];P.setSize&&P.setSize(b,_),v&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(T,b){if(f||T.toneMapping===os&&C.length===0)return!1;if(M=b,b!==null){let _=b.width,v=b.height;(o.width!==_||o.height!==v)&&this.setSize(_,v)}return y===!1&&T.setRenderTarget(o),p=T.toneMapping,T.toneMapping=os,!0},this.hasRenderPass=function(){return y},this.end=function(T,b){T.toneMapping=p,f=!0;let _=o,v=a;for(let D=0;D<C.length;D++){let P=C[D];P.enabled!==!1&&(P.render(T,v,_,b),P.needsSwap!==!1&&(_=v,v=v===a?l:a))}if(g!==T.outputColorSpace||x!==T.toneMapping){g=T.outputColorSpace,x=T.toneMapping,d.defines={},St.getTransfer(g)===Lt&&(d.defines.SRGB_TRANSFER="");let D=Q1[x];D&&(d.defines[D]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,T.setRenderTarget(M),T.render(u,m),M=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var y_=new ei,v_=new Rs(1,1),S_=new Oa(1),M_=new Ca,b_=new Pc,w_=new Ua,K0=[],Q0=[],e_=new Float32Array(16),t_=new Float32Array(9),n_=new Float32Array(4);function Yo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=K0[s];if(r===void 0&&(r=new Float32Array(s),K0[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Mn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function bn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function qh(n,e){let t=Q0[e];t===void 0&&(t=new Int32Array(e),Q0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function tw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function nw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;n.uniform2fv(this.addr,e),bn(t,e)}}function iw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Mn(t,e))return;n.uniform3fv(this.addr,e),bn(t,e)}}function sw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;n.uniform4fv(this.addr,e),bn(t,e)}}function rw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Mn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),bn(t,e)}else{if(Mn(t,i))return;n_.set(i),n.uniformMatrix2fv(this.addr,!1,n_),bn(t,i)}}function ow(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Mn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),bn(t,e)}else{if(Mn(t,i))return;t_.set(i),n.uniformMatrix3fv(this.addr,!1,t_),bn(t,i)}}function aw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Mn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),bn(t,e)}else{if(Mn(t,i))return;e_.set(i),n.uniformMatrix4fv(this.addr,!1,e_),bn(t,i)}}function lw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function cw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;n.uniform2iv(this.addr,e),bn(t,e)}}function hw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;n.uniform3iv(this.addr,e),bn(t,e)}}function uw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;n.uniform4iv(this.addr,e),bn(t,e)}}function dw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function fw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;n.uniform2uiv(this.addr,e),bn(t,e)}}function pw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;n.uniform3uiv(this.addr,e),bn(t,e)}}function mw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;n.uniform4uiv(this.addr,e),bn(t,e)}}function Yh(n){return n.version===0&&(n.compareFunction=df,n.needsUpdate=!0),n}function gw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Yh(v_):r=y_,t.setTexture2D(e||r,s)}function _w(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||b_,s)}function xw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Yh(S_):r=w_,t.setTextureCube(e||r,s)}function yw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||M_,s)}function vw(n){switch(n){case 5126:return tw;case 35664:return nw;case 35665:return iw;case 35666:return sw;case 35674:return rw;case 35675:return ow;case 35676:return aw;case 5124:case 35670:return lw;case 35667:case 35671:return cw;case 35668:case 35672:return hw;case 35669:case 35673:return uw;case 5125:return dw;case 36294:return fw;case 36295:return pw;case 36296:return mw;case 35678:case 36198:case 36298:case 36306:case 35682:return gw;case 35679:case 36299:case 36307:return _w;case 35680:case 36300:case 36308:case 36293:return xw;case 36289:case 36303:case 36311:case 36292:return yw}}function Sw(n,e){n.uniform1fv(this.addr,e)}function Mw(n,e){let t=Yo(e,this.size,2);n.uniform2fv(this.addr,t)}function bw(n,e){let t=Yo(e,this.size,3);n.uniform3fv(this.addr,t)}function ww(n,e){let t=Yo(e,this.size,4);n.uniform4fv(this.addr,t)}function Ew(n,e){let t=Yo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Tw(n,e){let t=Yo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Aw(n,e){let t=Yo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Rw(n,e){n.uniform1iv(this.addr,e)}function Cw(n,e){n.uniform2iv(this.addr,e)}function Pw(n,e){n.uniform3iv(this.addr,e)}function Iw(n,e){n.uniform4iv(this.addr,e)}function Lw(n,e){n.uniform1uiv(this.addr,e)}function Dw(n,e){n.uniform2uiv(this.addr,e)}function Nw(n,e){n.uniform3uiv(this.addr,e)}function Uw(n,e){n.uniform4uiv(this.addr,e)}function Fw(n,e,t){let i=this.cache,s=e.length,r=qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Yh(v_):o=y_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Ow(n,e,t){let i=this.cache,s=e.length,r=qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||b_,r[o])}function Bw(n,e,t){let i=this.cache,s=e.length,r=qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Yh(S_):o=w_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function zw(n,e,t){let i=this.cache,s=e.length,r=qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||M_,r[o])}function kw(n){switch(n){case 5126:return Sw;case 35664:return Mw;case 35665:return bw;case 35666:return ww;case 35674:return Ew;case 35675:return Tw;case 35676:return Aw;case 5124:case 35670:return Rw;case 35667:case 35671:return Cw;case 35668:case 35672:return Pw;case 35669:case 35673:return Iw;case 5125:return Lw;case 36294:return Dw;case 36295:return Nw;case 36296:return Uw;case 35678:case 36198:case 36298:case 36306:case 35682:return Fw;case 35679:case 36299:case 36307:return Ow;case 35680:case 36300:case 36308:case 36293:return Bw;case 36289:case 36303:case 36311:case 36292:return zw}}var Pf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=vw(t.type)}},If=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=kw(t.type)}},Lf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Rf=/(\w+)(\])?(\[|\.)?/g;function i_(n,e){n.seq.push(e),n.map[e.id]=e}function Vw(n,e,t){let i=n.name,s=i.length;for(Rf.lastIndex=0;;){let r=Rf.exec(i),o=Rf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){i_(t,c===void 0?new Pf(a,n,e):new If(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new Lf(a),i_(t,d)),t=d}}}var qo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Vw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function s_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var Gw=37297,Hw=0;function Ww(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var r_=new rt;function Xw(n){St._getMatrix(r_,St.workingColorSpace,n);let e=`mat3( ${r_.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case Ta:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function o_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Ww(n.getShaderSource(e),a)}else return r}function qw(n,e){let t=Xw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Yw={[$d]:"Linear",[Zd]:"Reinhard",[jd]:"Cineon",[Jd]:"ACESFilmic",[Qd]:"AgX",[ef]:"Neutral",[Kd]:"Custom"};function $w(n,e){let t=Yw[e];return t===void 0?(je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Hh=new q;function Zw(){St.getLuminanceCoefficients(Hh);let n=Hh.x.toFixed(4),e=Hh.y.toFixed(4),t=Hh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function jw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(hl).join(`
`)}function Jw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Kw(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function hl(n){return n!==""}function a_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function l_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Qw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Df(n){return n.replace(Qw,eE)}function eE(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Df(t)}var tE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function c_(n){return n.replace(tE,nE)}function nE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function h_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var iE={[Qa]:"SHADOWMAP_TYPE_PCF",[Go]:"SHADOWMAP_TYPE_VSM"};function sE(n){return iE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var rE={[Wo]:"ENVMAP_MODE_REFRACTION"};function oE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":rE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var aE={[Yd]:"ENVMAP_BLENDING_MULTIPLY",[P0]:"ENVMAP_BLENDING_MIX",[I0]:"ENVMAP_BLENDING_ADD"};function lE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":aE[n.combine]||"ENVMAP_BLENDING_NONE"}function cE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=sE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=oE(t),d=lE(t),u=jw(t),m=Jw(r),g=s.createProgram(),x,f,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(hl).join(`
`),x.length>0&&(x+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(hl).join(`
`),f.length>0&&(f+=`
`)):(x=[h_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(hl).join(`
`),f=[h_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==os?"#define TONE_MAPPING":"",t.toneMapping!==os?ft.tonemapping_pars_fragment:"",t.toneMapping!==os?$w("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,qw("linearToOutputTexel",t.outputColorSpace),Zw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(hl).join(`
`)),o=Df(o),o=a_(o,t),o=l_(o,t),a=Df(a),a=a_(a,t),a=l_(a,t),o=c_(o),a=c_(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,x=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,f=["#define varying in",t.glslVersion===pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let M=p+x+o,C=p+f+a,y=s_(s,s.VERTEX_SHADER,M),T=s_(s,s.FRAGMENT_SHADER,C);s.attachShader(g,y),s.attachShader(g,T),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function b(P){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",L=s.getShaderInfoLog(y)||"",O=s.getShaderInfoLog(T)||"",R=I.trim(),U=L.trim(),k=O.trim(),z=!0,$=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,y,T);else{let X=o_(s,y,"vertex"),Z=o_(s,T,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+R+`
`+X+`
`+Z)}else R!==""?je("WebGLProgram: Program Info Log:",R):(U===""||k==="")&&($=!1);$&&(P.diagnostics={runnable:z,programLog:R,vertexShader:{log:U,prefix:x},fragmentShader:{log:k,prefix:f}})}s.deleteShader(y),s.deleteShader(T),_=new qo(s,g),v=Kw(s,g)}let _;this.getUniforms=function(){return _===void 0&&b(this),_};let v;this.getAttributes=function(){return v===void 0&&b(this),v};let D=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(g,Gw)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Hw++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=y,this.fragmentShader=T,this}var hE=0,Nf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Uf(e),t.set(e,i)),i}},Uf=class{constructor(e){this.id=hE++,this.code=e,this.usedTimes=0}};function uE(n){return n===rr||n===rl||n===ol}function dE(n,e,t,i,s,r){let o=new Pa,a=new Nf,l=new Set,c=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,v,D,P,I,L){let O=P.fog,R=I.geometry,U=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,k=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,z=e.get(_.envMap||U,k),$=u[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&je("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let Z=R.morphAttributes.position||R.morphAttributes.normal||R.morphAttributes.color,te=Z!==void 0?Z.length:0,oe=0;R.morphAttributes.position!==void 0&&(oe=1),R.morphAttributes.normal!==void 0&&(oe=2),R.morphAttributes.color!==void 0&&(oe=3);let ce,Q,me,_e;if($){let Ce=ni[$];ce=Ce.vertexShader,Q=Ce.fragmentShader}else{ce=_.vertexShader,Q=_.fragmentShader;let Ce=a.getVertexShaderStage(_),ut=a.getFragmentShaderStage(_);a.update(_,Ce,ut),me=Ce.id,_e=ut.id}let ae=n.getRenderTarget(),de=n.state.buffers.depth.getReversed(),Ne=I.isInstancedMesh===!0,Ye=I.isBatchedMesh===!0,Be=!!_.map,st=!!_.matcap,at=!!z,$e=at&&z.isPMREMTexture===!0,pt=!!_.aoMap,Mt=!!_.lightMap,jt=!!_.bumpMap&&_.wireframe===!1,Ct=!!_.normalMap,rn=!!_.displacementMap,bt=!!_.emissiveMap,xn=!!_.metalnessMap,Qt=!!_.roughnessMap,ln=_.anisotropy>0,G=_.clearcoat>0,Pe=_.diffuseRoughness>0,Je=_.dispersion>0,lt=_.retroreflectivity>0,Ee=_.iridescence>0,zt=_.sheen>0,We=_.transmission>0,Ze=ln&&!!_.anisotropyMap,N=G&&!!_.clearcoatMap,w=G&&!!_.clearcoatNormalMap,j=G&&!!_.clearcoatRoughnessMap,pe=Pe&&!!_.diffuseRoughnessMap,he=Ee&&!!_.iridescenceMap,ve=Ee&&!!_.iridescenceThicknessMap,Se=zt&&!!_.sheenColorMap,ie=zt&&!!_.sheenRoughnessMap,re=!!_.specularMap,xe=!!_.specularColorMap,V=!!_.specularIntensityMap,le=We&&!!_.transmissionMap,se=We&&!!_.thicknessMap,Te=!!_.gradientMap,ye=!!_.alphaMap,we=_.alphaTest>0,Xe=!!_.alphaHash,et=!!_.extensions,fe=os;_.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(fe=n.toneMapping);let Ve=$e?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,tt={shaderID:$,shaderType:_.type,shaderName:_.name,vertexShader:ce,fragmentShader:Q,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:Ye,batchingColor:Ye&&I._colorsTexture!==null,instancing:Ne,instancingColor:Ne&&I.instanceColor!==null,instancingMorph:Ne&&I.morphTexture!==null,outputColorSpace:ae===null?n.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Be,matcap:st,envMap:at,envMapMode:at&&z.mapping,envMapPMREM:$e,envMapMaxLod:$e?Ve.length-1:null,envMapSize:$e?Ve[0].width:null,aoMap:pt,lightMap:Mt,bumpMap:jt,normalMap:Ct,displacementMap:rn,emissiveMap:bt,normalMapObjectSpace:Ct&&_.normalMapType===N0,normalMapTangentSpace:Ct&&_.normalMapType===kh,packedNormalMap:Ct&&_.normalMapType===kh&&uE(_.normalMap.format),metalnessMap:xn,roughnessMap:Qt,anisotropy:ln,anisotropyMap:Ze,clearcoat:G,clearcoatMap:N,clearcoatNormalMap:w,clearcoatRoughnessMap:j,diffuseRoughness:Pe,diffuseRoughnessMap:pe,dispersion:Je,retroreflection:lt,iridescence:Ee,iridescenceMap:he,iridescenceThicknessMap:ve,sheen:zt,sheenColorMap:Se,sheenRoughnessMap:ie,specularMap:re,specularColorMap:xe,specularIntensityMap:V,transmission:We,transmissionMap:le,thicknessMap:se,gradientMap:Te,opaque:_.transparent===!1&&_.blending===Ho&&_.alphaToCoverage===!1,alphaMap:ye,alphaTest:we,alphaHash:Xe,combine:_.combine,mapUv:Be&&m(_.map.channel),aoMapUv:pt&&m(_.aoMap.channel),lightMapUv:Mt&&m(_.lightMap.channel),bumpMapUv:jt&&m(_.bumpMap.channel),normalMapUv:Ct&&m(_.normalMap.channel),displacementMapUv:rn&&m(_.displacementMap.channel),emissiveMapUv:bt&&m(_.emissiveMap.channel),metalnessMapUv:xn&&m(_.metalnessMap.channel),roughnessMapUv:Qt&&m(_.roughnessMap.channel),anisotropyMapUv:Ze&&m(_.anisotropyMap.channel),clearcoatMapUv:N&&m(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&m(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&m(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pe&&m(_.diffuseRoughnessMap.channel),iridescenceMapUv:he&&m(_.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&m(_.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&m(_.sheenColorMap.channel),sheenRoughnessMapUv:ie&&m(_.sheenRoughnessMap.channel),specularMapUv:re&&m(_.specularMap.channel),specularColorMapUv:xe&&m(_.specularColorMap.channel),specularIntensityMapUv:V&&m(_.specularIntensityMap.channel),transmissionMapUv:le&&m(_.transmissionMap.channel),thicknessMapUv:se&&m(_.thicknessMap.channel),alphaMapUv:ye&&m(_.alphaMap.channel),vertexTangents:!!R.attributes.tangent&&(Ct||ln),vertexNormals:!!R.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!R.attributes.color&&R.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!R.attributes.uv&&(Be||ye),fog:!!O,useFog:_.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||R.attributes.normal===void 0&&Ct===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:de,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:R.attributes.position!==void 0,morphTargets:R.morphAttributes.position!==void 0,morphNormals:R.morphAttributes.normal!==void 0,morphColors:R.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:oe,numSunLights:v.sun.length,numDirLights:v.directional.length,numPointLights:v.point.length,numSpotLights:v.spot.length,numSpotLightMaps:v.spotLightMap.length,numRectAreaLights:v.rectArea.length,numHemiLights:v.hemi.length,numSunLightShadows:v.sunShadowMap.length,numDirLightShadows:v.directionalShadowMap.length,numPointLightShadows:v.pointShadowMap.length,numSpotLightShadows:v.spotShadowMap.length,numSpotLightShadowsWithMaps:v.numSpotLightShadowsWithMaps,numLightProbes:v.numLightProbes,numLightProbeGrids:L.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:fe,decodeVideoTexture:Be&&_.map.isVideoTexture===!0&&St.getTransfer(_.map.colorSpace)===Lt,decodeVideoTextureEmissive:bt&&_.emissiveMap.isVideoTexture===!0&&St.getTransfer(_.emissiveMap.colorSpace)===Lt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===rs,flipSided:_.side===ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:et&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&_.extensions.multiDraw===!0||Ye)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function x(_){let v=[];if(_.shaderID?v.push(_.shaderID):(v.push(_.customVertexShaderID),v.push(_.customFragmentShaderID)),_.defines!==void 0)for(let D in _.defines)v.push(D),v.push(_.defines[D]);return _.isRawShaderMaterial===!1&&(f(v,_),p(v,_),v.push(n.outputColorSpace)),v.push(_.customProgramCacheKey),v.join()}function f(_,v){_.push(v.precision),_.push(v.outputColorSpace),_.push(v.envMapMode),_.push(v.envMapPMREM),_.push(v.envMapMaxLod),_.push(v.envMapSize),_.push(v.mapUv),_.push(v.alphaMapUv),_.push(v.lightMapUv),_.push(v.aoMapUv),_.push(v.bumpMapUv),_.push(v.normalMapUv),_.push(v.displacementMapUv),_.push(v.emissiveMapUv),_.push(v.metalnessMapUv),_.push(v.roughnessMapUv),_.push(v.anisotropyMapUv),_.push(v.clearcoatMapUv),_.push(v.clearcoatNormalMapUv),_.push(v.clearcoatRoughnessMapUv),_.push(v.diffuseRoughnessMapUv),_.push(v.iridescenceMapUv),_.push(v.iridescenceThicknessMapUv),_.push(v.sheenColorMapUv),_.push(v.sheenRoughnessMapUv),_.push(v.specularMapUv),_.push(v.specularColorMapUv),_.push(v.specularIntensityMapUv),_.push(v.transmissionMapUv),_.push(v.thicknessMapUv),_.push(v.combine),_.push(v.fogExp2),_.push(v.sizeAttenuation),_.push(v.morphTargetsCount),_.push(v.numSunLights),_.push(v.numDirLights),_.push(v.numPointLights),_.push(v.numSpotLights),_.push(v.numSpotLightMaps),_.push(v.numHemiLights),_.push(v.numRectAreaLights),_.push(v.numSunLightShadows),_.push(v.numDirLightShadows),_.push(v.numPointLightShadows),_.push(v.numSpotLightShadows),_.push(v.numSpotLightShadowsWithMaps),_.push(v.numLightProbes),_.push(v.numLightProbeGrids),_.push(v.shadowMapType),_.push(v.toneMapping),_.push(v.numClippingPlanes),_.push(v.numClipIntersection),_.push(v.depthPacking)}function p(_,v){o.disableAll(),v.instancing&&o.enable(0),v.instancingColor&&o.enable(1),v.instancingMorph&&o.enable(2),v.matcap&&o.enable(3),v.envMap&&o.enable(4),v.normalMapObjectSpace&&o.enable(5),v.normalMapTangentSpace&&o.enable(6),v.clearcoat&&o.enable(7),v.iridescence&&o.enable(8),v.alphaTest&&o.enable(9),v.vertexColors&&o.enable(10),v.vertexAlphas&&o.enable(11),v.vertexUv1s&&o.enable(12),v.vertexUv2s&&o.enable(13),v.vertexUv3s&&o.enable(14),v.vertexTangents&&o.enable(15),v.anisotropy&&o.enable(16),v.alphaHash&&o.enable(17),v.batching&&o.enable(18),v.dispersion&&o.enable(19),v.retroreflection&&o.enable(24),v.diffuseRoughness&&o.enable(25),v.batchingColor&&o.enable(20),v.gradientMap&&o.enable(21),v.packedNormalMap&&o.enable(22),v.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),v.fog&&o.enable(0),v.useFog&&o.enable(1),v.flatShading&&o.enable(2),v.logarithmicDepthBuffer&&o.enable(3),v.reversedDepthBuffer&&o.enable(4),v.skinning&&o.enable(5),v.morphTargets&&o.enable(6),v.morphNormals&&o.enable(7),v.morphColors&&o.enable(8),v.premultipliedAlpha&&o.enable(9),v.shadowMapEnabled&&o.enable(10),v.doubleSided&&o.enable(11),v.flipSided&&o.enable(12),v.useDepthPacking&&o.enable(13),v.dithering&&o.enable(14),v.transmission&&o.enable(15),v.sheen&&o.enable(16),v.opaque&&o.enable(17),v.pointsUvs&&o.enable(18),v.decodeVideoTexture&&o.enable(19),v.decodeVideoTextureEmissive&&o.enable(20),v.alphaToCoverage&&o.enable(21),v.numLightProbeGrids>0&&o.enable(22),v.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function M(_){let v=u[_.type],D;if(v){let P=ni[v];D=ll.clone(P.uniforms)}else D=_.uniforms;return D}function C(_,v){let D=h.get(v);return D!==void 0?++D.usedTimes:(D=new cE(n,v,_,s),c.push(D),h.set(v,D)),D}function y(_){if(--_.usedTimes===0){let v=c.indexOf(_);c[v]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function T(_){a.remove(_)}function b(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:M,acquireProgram:C,releaseProgram:y,releaseShaderCache:T,programs:c,dispose:b}}function fE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function pE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function u_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function d_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(u){let m=0;return u.isInstancedMesh&&(m+=2),u.isSkinnedMesh&&(m+=1),m}function a(u,m,g,x,f,p){let M=n[e];return M===void 0?(M={id:u.id,object:u,geometry:m,material:g,materialVariant:o(u),groupOrder:x,renderOrder:u.renderOrder,z:f,group:p},n[e]=M):(M.id=u.id,M.object=u,M.geometry=m,M.material=g,M.materialVariant=o(u),M.groupOrder=x,M.renderOrder=u.renderOrder,M.z=f,M.group=p),e++,M}function l(u,m,g,x,f,p,M){M.reversedDepth===!0&&(f=-f);let C=a(u,m,g,x,f,p);g.transmission>0?i.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(u,m,g,x,f,p){let M=a(u,m,g,x,f,p);g.transmission>0?i.unshift(M):g.transparent===!0?s.unshift(M):t.unshift(M)}function h(u,m){t.length>1&&t.sort(u||pE),i.length>1&&i.sort(m||u_),s.length>1&&s.sort(m||u_)}function d(){for(let u=e,m=n.length;u<m;u++){let g=n[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function mE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new d_,n.set(i,[o])):s>=r.length?(o=new d_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function gE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new q,color:new ht};break;case"SpotLight":t={position:new q,direction:new q,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new q,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new q,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new q,halfWidth:new q,halfHeight:new q};break}return n[e.id]=t,t}}}function _E(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var xE=0;function yE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function vE(n){let e=new gE,t=_E(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new q);let s=new q,r=new Ot,o=new Ot;function a(c){let h=0,d=0,u=0;for(let L=0;L<9;L++)i.probe[L].set(0,0,0);let m=0,g=0,x=0,f=0,p=0,M=0,C=0,y=0,T=0,b=0,_=0,v=0,D=0,P=0;c.sort(yE);for(let L=0,O=c.length;L<O;L++){let R=c[L],U=R.color,k=R.intensity,z=R.distance,$=null;if(R.shadow&&R.shadow.map&&(R.shadow.map.texture.format===rr?$=R.shadow.map.texture:$=R.shadow.map.depthTexture||R.shadow.map.texture),R.isAmbientLight)h+=U.r*k,d+=U.g*k,u+=U.b*k;else if(R.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(R.sh.coefficients[X],k);P++}else if(R.isSunLight){let X=e.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Z=R.shadow,te=t.get(R);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[g]=te,i.sunShadowMap[g]=$;let oe=Z.getViewportCount();for(let ce=0;ce<oe;ce++)i.sunShadowMatrix[x+ce]=Z.getMatrix(ce),i.sunShadowCascade[x+ce]=Z._cascadeData[ce];x+=oe,g++}i.sun[m]=X,m++}else if(R.isDirectionalLight){let X=e.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Z=R.shadow,te=t.get(R);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,i.directionalShadow[f]=te,i.directionalShadowMap[f]=$,i.directionalShadowMatrix[f]=R.shadow.matrix,T++}i.directional[f]=X,f++}else if(R.isSpotLight){let X=e.get(R);X.position.setFromMatrixPosition(R.matrixWorld),X.color.copy(U).multiplyScalar(k),X.distance=z,X.coneCos=Math.cos(R.angle),X.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),X.decay=R.decay,i.spot[M]=X;let Z=R.shadow;if(R.map&&(i.spotLightMap[v]=R.map,v++,Z.updateMatrices(R),R.castShadow&&D++),i.spotLightMatrix[M]=Z.matrix,R.castShadow){let te=t.get(R);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,i.spotShadow[M]=te,i.spotShadowMap[M]=$,_++}M++}else if(R.isRectAreaLight){let X=e.get(R);X.color.copy(U).multiplyScalar(k),X.halfWidth.set(R.width*.5,0,0),X.halfHeight.set(0,R.height*.5,0),i.rectArea[C]=X,C++}else if(R.isPointLight){let X=e.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),X.distance=R.distance,X.decay=R.decay,R.castShadow){let Z=R.shadow,te=t.get(R);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,te.shadowCameraNear=Z.camera.near,te.shadowCameraFar=Z.camera.far,i.pointShadow[p]=te,i.pointShadowMap[p]=$,i.pointShadowMatrix[p]=R.shadow.matrix,b++}i.point[p]=X,p++}else if(R.isHemisphereLight){let X=e.get(R);X.skyColor.copy(R.color).multiplyScalar(k),X.groundColor.copy(R.groundColor).multiplyScalar(k),i.hemi[y]=X,y++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ie.LTC_FLOAT_1,i.rectAreaLTC2=Ie.LTC_FLOAT_2):(i.rectAreaLTC1=Ie.LTC_HALF_1,i.rectAreaLTC2=Ie.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let I=i.hash;(I.sunLength!==m||I.directionalLength!==f||I.pointLength!==p||I.spotLength!==M||I.rectAreaLength!==C||I.hemiLength!==y||I.numSunShadows!==g||I.numDirectionalShadows!==T||I.numPointShadows!==b||I.numSpotShadows!==_||I.numSpotMaps!==v||I.numLightProbes!==P)&&(i.sun.length=m,i.directional.length=f,i.spot.length=M,i.rectArea.length=C,i.point.length=p,i.hemi.length=y,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=b,i.pointShadowMap.length=b,i.pointShadowMatrix.length=b,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+v-D,i.spotLightMap.length=v,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=P,I.sunLength=m,I.directionalLength=f,I.pointLength=p,I.spotLength=M,I.rectAreaLength=C,I.hemiLength=y,I.numSunShadows=g,I.numDirectionalShadows=T,I.numPointShadows=b,I.numSpotShadows=_,I.numSpotMaps=v,I.numLightProbes=P,i.version=xE++)}function l(c,h){let d=0,u=0,m=0,g=0,x=0,f=0,p=h.matrixWorldInverse;for(let M=0,C=c.length;M<C;M++){let y=c[M];if(y.isSunLight){let T=i.sun[d];T.direction.setFromMatrixPosition(y.matrixWorld),T.direction.transformDirection(p),d++}else if(y.isDirectionalLight){let T=i.directional[u];T.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(p),u++}else if(y.isSpotLight){let T=i.spot[g];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(p),T.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(p),g++}else if(y.isRectAreaLight){let T=i.rectArea[x];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(p),o.identity(),r.copy(y.matrixWorld),r.premultiply(p),o.extractRotation(r),T.halfWidth.set(y.width*.5,0,0),T.halfHeight.set(0,y.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),x++}else if(y.isPointLight){let T=i.point[m];T.position.setFromMatrixPosition(y.matrixWorld),T.position.applyMatrix4(p),m++}else if(y.isHemisphereLight){let T=i.hemi[f];T.direction.setFromMatrixPosition(y.matrixWorld),T.direction.transformDirection(p),f++}}}return{setup:a,setupView:l,state:i}}function f_(n){let e=new vE(n),t=[],i=[],s=[];function r(d){h.camera=d,t.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function SE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new f_(n),e.set(s,[a])):r>=o.length?(a=new f_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var ME=`void main() {
gl_Position = vec4( position, 1.0 );
}`,bE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
const float samples = float( VSM_SAMPLES );
float mean = 0.0;
float squared_mean = 0.0;
float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
for ( float i = 0.0; i < samples; i ++ ) {
float uvOffset = uvStart + i * uvStride;
#ifdef HORIZONTAL_PASS
vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
mean += distribution.x;
squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
#else
float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
mean += depth;
squared_mean += depth * depth;
#endif
}
mean = mean / samples;
squared_mean = squared_mean / samples;
float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,wE=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],EE=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],p_=new Ot,cl=new q,Cf=new q;function TE(n,e,t){let i=new js,s=new Ke,r=new Ke,o=new Dt,a=new kc,l=new Vc,c={},h=t.maxTextureSize,d={[sr]:ti,[ti]:sr,[rs]:rs},u=new Ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:ME,fragmentShader:bE}),m=u.clone();m.defines.HORIZONTAL_PASS=1;let g=new ii;g.setAttribute("position",new Bi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new kn(g,u),f=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Qa;let p=this.type;this.render=function(b,_,v){if(f.enabled===!1||f.autoUpdate===!1&&f.needsUpdate===!1||b.length===0)return;this.type===u0&&(je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Qa);let D=n.getRenderTarget(),P=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),L=n.state;L.setBlending(Dr),L.buffers.depth.getReversed()===!0?L.buffers.color.setClear(0,0,0,0):L.buffers.color.setClear(1,1,1,1),L.buffers.depth.setTest(!0),L.setScissorTest(!1);let O=p!==this.type;O&&_.traverse(function(R){R.material&&(Array.isArray(R.material)?R.material.forEach(U=>U.needsUpdate=!0):R.material.needsUpdate=!0)});for(let R=0,U=b.length;R<U;R++){let k=b[R],z=k.shadow;if(z===void 0){je("WebGLShadowMap:",k,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let $=z.getFrameExtents();s.multiply($),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/$.x),s.x=r.x*$.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/$.y),s.y=r.y*$.y,z.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=X,z.map===null||O===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===Go){if(k.isPointLight){je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new _i(s.x,s.y,{format:rr,type:Wi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),z.map.texture.name=k.name+".shadowMap",z.map.depthTexture=new Rs(s.x,s.y,Hi),z.map.depthTexture.name=k.name+".shadowMapDepth",z.map.depthTexture.format=Ts,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=_n,z.map.depthTexture.magFilter=_n}else k.isPointLight?(z.map=new ul(s.x),z.map.depthTexture=new Oa(s.x,Gi)):(z.map=new _i(s.x,s.y),z.map.depthTexture=new Rs(s.x,s.y,Gi)),z.map.depthTexture.name=k.name+".shadowMap",z.map.depthTexture.format=Ts,this.type===Qa?(z.map.depthTexture.compareFunction=X?uf:hf,z.map.depthTexture.minFilter=Kn,z.map.depthTexture.magFilter=Kn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=_n,z.map.depthTexture.magFilter=_n);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Z=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();k.isPointLight!==!0&&z.updateMatrices(k,v);let te=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:v.layers;for(let oe=0;oe<Z;oe++){let ce=z.getCamera(oe);if(k.isPointLight){let Q=z.camera,me=z.matrix,_e=k.distance||Q.far;_e!==Q.far&&(Q.far=_e,Q.updateProjectionMatrix()),cl.setFromMatrixPosition(k.matrixWorld),Q.position.copy(cl),Cf.copy(Q.position),Cf.add(wE[oe]),Q.up.copy(EE[oe]),Q.lookAt(Cf),Q.updateMatrixWorld(),me.makeTranslation(-cl.x,-cl.y,-cl.z),p_.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),z._frustum.setFromProjectionMatrix(p_,Q.coordinateSystem,Q.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,oe),n.clear();else{oe===0&&(n.setRenderTarget(z.map),n.clear());let Q=z.getViewport(oe);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),L.viewport(o)}i=z.getFrustum(oe),y(_,v,ce,k,te,this.type)}z.isPointLightShadow!==!0&&this.type===Go&&M(z,v),z.needsUpdate=!1}p=this.type,f.needsUpdate=!1,n.setRenderTarget(D,P,I)};function M(b,_){let v=e.update(x);u.defines.VSM_SAMPLES!==b.blurSamples&&(u.defines.VSM_SAMPLES=b.blurSamples,m.defines.VSM_SAMPLES=b.blurSamples,u.needsUpdate=!0,m.needsUpdate=!0),b.mapPass===null?b.mapPass=new _i(s.x,s.y,{format:rr,type:Wi}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),u.uniforms.shadow_pass.value=b.map.depthTexture,u.uniforms.resolution.value.set(b.map.width,b.map.height),u.uniforms.radius.value=b.radius,n.setRenderTarget(b.mapPass),n.clear(),n.renderBufferDirect(_,null,v,u,x,null),m.uniforms.shadow_pass.value=b.mapPass.texture,m.uniforms.resolution.value.set(b.map.width,b.map.height),m.uniforms.radius.value=b.radius,n.setRenderTarget(b.map),n.clear(),n.renderBufferDirect(_,null,v,m,x,null)}function C(b,_,v,D){let P=null,I=v.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(I!==void 0)P=I;else if(P=v.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let L=P.uuid,O=_.uuid,R=c[L];R===void 0&&(R={},c[L]=R);let U=R[O];U===void 0&&(U=P.clone(),R[O]=U,_.addEventListener("dispose",T)),P=U}if(P.visible=_.visible,P.wireframe=_.wireframe,D===Go?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?_.shadowSide:d[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=_.wireframeLinewidth,P.linewidth=_.linewidth,v.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let L=n.properties.get(P);L.light=v}return P}function y(b,_,v,D,P,I){if(b.visible===!1)return;if(b.layers.test(P)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&I===Go)&&(!b.frustumCulled||b.intersectsFrustum(i))){b.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,b.matrixWorld);let R=e.update(b),U=b.material;if(Array.isArray(U)){let k=R.groups;for(let z=0,$=k.length;z<$;z++){let X=k[z],Z=U[X.materialIndex];if(Z&&Z.visible){let te=C(b,Z,D,I);b.onBeforeShadow(n,b,_,v,R,te,X),n.renderBufferDirect(v,null,R,te,b,X),b.onAfterShadow(n,b,_,v,R,te,X)}}}else if(U.visible){let k=C(b,U,D,I);b.onBeforeShadow(n,b,_,v,R,k,null),n.renderBufferDirect(v,null,R,k,b,null),b.onAfterShadow(n,b,_,v,R,k,null)}}let O=b.children;for(let R=0,U=O.length;R<U;R++)y(O[R],_,v,D,P,I)}function T(b){b.target.removeEventListener("dispose",T);for(let v in c){let D=c[v],P=b.target.uuid;P in D&&(D[P].dispose(),delete D[P])}}}function AE(n,e){function t(){let V=!1,le=new Dt,se=null,Te=new Dt(0,0,0,0);return{setMask:function(ye){se!==ye&&!V&&(n.colorMask(ye,ye,ye,ye),se=ye)},setLocked:function(ye){V=ye},setClear:function(ye,we,Xe,et,fe){fe===!0&&(ye*=et,we*=et,Xe*=et),le.set(ye,we,Xe,et),Te.equals(le)===!1&&(n.clearColor(ye,we,Xe,et),Te.copy(le))},reset:function(){V=!1,se=null,Te.set(-1,0,0,0)}}}function i(){let V=!1,le=!1,se=null,Te=null,ye=null;return{setReversed:function(we){if(le!==we){let Xe=e.get("EXT_clip_control");we?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),le=we;let et=ye;ye=null,this.setClear(et)}},getReversed:function(){return le},setTest:function(we){we?de(n.DEPTH_TEST):Ne(n.DEPTH_TEST)},setMask:function(we){se!==we&&!V&&(n.depthMask(we),se=we)},setFunc:function(we){if(le&&(we=W0[we]),Te!==we){switch(we){case xc:n.depthFunc(n.NEVER);break;case yc:n.depthFunc(n.ALWAYS);break;case vc:n.depthFunc(n.LESS);break;case Lo:n.depthFunc(n.LEQUAL);break;case Sc:n.depthFunc(n.EQUAL);break;case Mc:n.depthFunc(n.GEQUAL);break;case bc:n.depthFunc(n.GREATER);break;case wc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=we}},setLocked:function(we){V=we},setClear:function(we){ye!==we&&(ye=we,le&&(we=1-we),n.clearDepth(we))},reset:function(){V=!1,se=null,Te=null,ye=null,le=!1}}}function s(){let V=!1,le=null,se=null,Te=null,ye=null,we=null,Xe=null,et=null,fe=null;return{setTest:function(Ve){V||(Ve?de(n.STENCIL_TEST):Ne(n.STENCIL_TEST))},setMask:function(Ve){le!==Ve&&!V&&(n.stencilMask(Ve),le=Ve)},setFunc:function(Ve,tt,Ce){(se!==Ve||Te!==tt||ye!==Ce)&&(n.stencilFunc(Ve,tt,Ce),se=Ve,Te=tt,ye=Ce)},setOp:function(Ve,tt,Ce){(we!==Ve||Xe!==tt||et!==Ce)&&(n.stencilOp(Ve,tt,Ce),we=Ve,Xe=tt,et=Ce)},setLocked:function(Ve){V=Ve},setClear:function(Ve){fe!==Ve&&(n.clearStencil(Ve),fe=Ve)},reset:function(){V=!1,le=null,se=null,Te=null,ye=null,we=null,Xe=null,et=null,fe=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,h={},d={},u={},m=new WeakMap,g=[],x=null,f=!1,p=null,M=null,C=null,y=null,T=null,b=null,_=null,v=new ht(0,0,0),D=0,P=!1,I=null,L=null,O=null,R=null,U=null,k=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,$=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?($=parseFloat(/^WebGL (\d)/.exec(X)[1]),z=$>=1):X.indexOf("OpenGL ES")!==-1&&($=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),z=$>=2);let Z=null,te={},oe=n.getParameter(n.SCISSOR_BOX),ce=n.getParameter(n.VIEWPORT),Q=new Dt().fromArray(oe),me=new Dt().fromArray(ce);function _e(V,le,se,Te){let ye=new Uint8Array(4),we=n.createTexture();n.bindTexture(V,we),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<se;Xe++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(le,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(le+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return we}let ae={};ae[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),ae[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ae[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ae[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),de(n.DEPTH_TEST),o.setFunc(Lo),jt(!1),Ct(Vd),de(n.CULL_FACE),pt(Dr);function de(V){h[V]!==!0&&(n.enable(V),h[V]=!0)}function Ne(V){h[V]!==!1&&(n.disable(V),h[V]=!1)}function Ye(V,le){return u[V]!==le?(n.bindFramebuffer(V,le),u[V]=le,V===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=le),V===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=le),!0):!1}function Be(V,le){let se=g,Te=!1;if(V){se=m.get(le),se===void 0&&(se=[],m.set(le,se));let ye=V.textures;if(se.length!==ye.length||se[0]!==n.COLOR_ATTACHMENT0){for(let we=0,Xe=ye.length;we<Xe;we++)se[we]=n.COLOR_ATTACHMENT0+we;se.length=ye.length,Te=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Te=!0);Te&&n.drawBuffers(se)}function st(V){return x!==V?(n.useProgram(V),x=V,!0):!1}let at={[Nr]:n.FUNC_ADD,[f0]:n.FUNC_SUBTRACT,[p0]:n.FUNC_REVERSE_SUBTRACT};at[m0]=n.MIN,at[g0]=n.MAX;let $e={[_0]:n.ZERO,[x0]:n.ONE,[y0]:n.SRC_COLOR,[Xd]:n.SRC_ALPHA,[E0]:n.SRC_ALPHA_SATURATE,[b0]:n.DST_COLOR,[S0]:n.DST_ALPHA,[v0]:n.ONE_MINUS_SRC_COLOR,[qd]:n.ONE_MINUS_SRC_ALPHA,[w0]:n.ONE_MINUS_DST_COLOR,[M0]:n.ONE_MINUS_DST_ALPHA,[T0]:n.CONSTANT_COLOR,[A0]:n.ONE_MINUS_CONSTANT_COLOR,[R0]:n.CONSTANT_ALPHA,[C0]:n.ONE_MINUS_CONSTANT_ALPHA};function pt(V,le,se,Te,ye,we,Xe,et,fe,Ve){if(V===Dr){f===!0&&(Ne(n.BLEND),f=!1);return}if(f===!1&&(de(n.BLEND),f=!0),V!==d0){if(V!==p||Ve!==P){if((M!==Nr||T!==Nr)&&(n.blendEquation(n.FUNC_ADD),M=Nr,T=Nr),Ve)switch(V){case Ho:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFunc(n.ONE,n.ONE);break;case Hd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:it("WebGLState: Invalid blending: ",V);break}else switch(V){case Ho:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Hd:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wd:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",V);break}C=null,y=null,b=null,_=null,v.set(0,0,0),D=0,p=V,P=Ve}return}ye=ye||le,we=we||se,Xe=Xe||Te,(le!==M||ye!==T)&&(n.blendEquationSeparate(at[le],at[ye]),M=le,T=ye),(se!==C||Te!==y||we!==b||Xe!==_)&&(n.blendFuncSeparate($e[se],$e[Te],$e[we],$e[Xe]),C=se,y=Te,b=we,_=Xe),(et.equals(v)===!1||fe!==D)&&(n.blendColor(et.r,et.g,et.b,fe),v.copy(et),D=fe),p=V,P=!1}function Mt(V,le){V.side===rs?Ne(n.CULL_FACE):de(n.CULL_FACE);let se=V.side===ti;le&&(se=!se),jt(se),V.blending===Ho&&V.transparent===!1?pt(Dr):pt(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Te=V.stencilWrite;a.setTest(Te),Te&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),bt(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?de(n.SAMPLE_ALPHA_TO_COVERAGE):Ne(n.SAMPLE_ALPHA_TO_COVERAGE)}function jt(V){I!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),I=V)}function Ct(V){V!==c0?(de(n.CULL_FACE),V!==L&&(V===Vd?n.cullFace(n.BACK):V===h0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ne(n.CULL_FACE),L=V}function rn(V){V!==O&&(z&&n.lineWidth(V),O=V)}function bt(V,le,se){V?(de(n.POLYGON_OFFSET_FILL),(R!==le||U!==se)&&(R=le,U=se,o.getReversed()&&(le=-le,se=-se),n.polygonOffset(le,se))):Ne(n.POLYGON_OFFSET_FILL)}function xn(V){V?de(n.SCISSOR_TEST):Ne(n.SCISSOR_TEST)}function Qt(V){V===void 0&&(V=n.TEXTURE0+k-1),Z!==V&&(n.activeTexture(V),Z=V)}function ln(V,le,se){se===void 0&&(Z===null?se=n.TEXTURE0+k-1:se=Z);let Te=te[se];Te===void 0&&(Te={type:void 0,texture:void 0},te[se]=Te),(Te.type!==V||Te.texture!==le)&&(Z!==se&&(n.activeTexture(se),Z=se),n.bindTexture(V,le||ae[V]),Te.type=V,Te.texture=le)}function G(){let V=te[Z];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function lt(){try{n.texSubImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function Ze(){try{n.texStorage2D(...arguments)}catch(V){it("WebGLState:",V)}}function N(){try{n.texStorage3D(...arguments)}catch(V){it("WebGLState:",V)}}function w(){try{n.texImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function j(){try{n.texImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function pe(V){return d[V]!==void 0?d[V]:n.getParameter(V)}function he(V,le){d[V]!==le&&(n.pixelStorei(V,le),d[V]=le)}function ve(V){Q.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),Q.copy(V))}function Se(V){me.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),me.copy(V))}function ie(V,le){let se=c.get(le);se===void 0&&(se=new WeakMap,c.set(le,se));let Te=se.get(V);Te===void 0&&(Te=n.getUniformBlockIndex(le,V.name),n.uniformBlockBinding(le,Te,Te),se.set(V,Te))}function re(V,le,se){let ye=c.get(le).get(V);l[ye]!==se&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,se),l[ye]=se)}function xe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},Z=null,te={},u={},l={},m=new WeakMap,g=[],x=null,f=!1,p=null,M=null,C=null,y=null,T=null,b=null,_=null,v=new ht(0,0,0),D=0,P=!1,I=null,L=null,O=null,R=null,U=null,Q.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:de,disable:Ne,bindFramebuffer:Ye,drawBuffers:Be,useProgram:st,setBlending:pt,setMaterial:Mt,setFlipSided:jt,setCullFace:Ct,setLineWidth:rn,setPolygonOffset:bt,setScissorTest:xn,activeTexture:Qt,bindTexture:ln,unbindTexture:G,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:w,texImage3D:j,pixelStorei:he,getParameter:pe,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:Ze,texStorage3D:N,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:zt,compressedTexSubImage3D:We,scissor:ve,viewport:Se,reset:xe}}function RE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,h=new WeakMap,d=new Set,u,m=new WeakMap,g=new Set,x=new FinalizationRegistry(N=>g.delete(N)),f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(N,w){return f?new OffscreenCanvas(N,w):Aa("canvas")}function M(N,w,j){let pe=1,he=Ze(N);if((he.width>j||he.height>j)&&(pe=j/Math.max(he.width,he.height)),pe<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let ve=Math.floor(pe*he.width),Se=Math.floor(pe*he.height);u===void 0&&(u=p(ve,Se));let ie=w?p(ve,Se):u;return ie.width=ve,ie.height=Se,ie.getContext("2d").drawImage(N,0,0,ve,Se),je("WebGLRenderer: Texture has been resized from ("+he.width+"x"+he.height+") to ("+ve+"x"+Se+")."),ie}else return"data"in N&&je("WebGLRenderer: Image in DataTexture is too big ("+he.width+"x"+he.height+")."),N;return N}function C(N){return N.generateMipmaps}function y(N){n.generateMipmap(N)}function T(N){return N.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?n.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(N,w,j,pe,he,ve=!1){if(N!==null){if(n[N]!==void 0)return n[N];je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let Se;pe&&(Se=e.get("EXT_texture_norm16"),Se||je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=w;if(w===n.RED&&(j===n.FLOAT&&(ie=n.R32F),j===n.HALF_FLOAT&&(ie=n.R16F),j===n.UNSIGNED_BYTE&&(ie=n.R8),j===n.UNSIGNED_SHORT&&Se&&(ie=Se.R16_EXT),j===n.SHORT&&Se&&(ie=Se.R16_SNORM_EXT)),w===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.R8UI),j===n.UNSIGNED_SHORT&&(ie=n.R16UI),j===n.UNSIGNED_INT&&(ie=n.R32UI),j===n.BYTE&&(ie=n.R8I),j===n.SHORT&&(ie=n.R16I),j===n.INT&&(ie=n.R32I)),w===n.RG&&(j===n.FLOAT&&(ie=n.RG32F),j===n.HALF_FLOAT&&(ie=n.RG16F),j===n.UNSIGNED_BYTE&&(ie=n.RG8),j===n.UNSIGNED_SHORT&&Se&&(ie=Se.RG16_EXT),j===n.SHORT&&Se&&(ie=Se.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.RG8UI),j===n.UNSIGNED_SHORT&&(ie=n.RG16UI),j===n.UNSIGNED_INT&&(ie=n.RG32UI),j===n.BYTE&&(ie=n.RG8I),j===n.SHORT&&(ie=n.RG16I),j===n.INT&&(ie=n.RG32I)),w===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.RGB8UI),j===n.UNSIGNED_SHORT&&(ie=n.RGB16UI),j===n.UNSIGNED_INT&&(ie=n.RGB32UI),j===n.BYTE&&(ie=n.RGB8I),j===n.SHORT&&(ie=n.RGB16I),j===n.INT&&(ie=n.RGB32I)),w===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(ie=n.RGBA16UI),j===n.UNSIGNED_INT&&(ie=n.RGBA32UI),j===n.BYTE&&(ie=n.RGBA8I),j===n.SHORT&&(ie=n.RGBA16I),j===n.INT&&(ie=n.RGBA32I)),w===n.RGB&&(j===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGB16_EXT),j===n.SHORT&&Se&&(ie=Se.RGB16_SNORM_EXT),j===n.UNSIGNED_INT_5_9_9_9_REV&&(ie=n.RGB9_E5),j===n.UNSIGNED_INT_10F_11F_11F_REV&&(ie=n.R11F_G11F_B10F)),w===n.RGBA){let re=ve?Ta:St.getTransfer(he);j===n.FLOAT&&(ie=n.RGBA32F),j===n.HALF_FLOAT&&(ie=n.RGBA16F),j===n.UNSIGNED_BYTE&&(ie=re===Lt?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGBA16_EXT),j===n.SHORT&&Se&&(ie=Se.RGBA16_SNORM_EXT),j===n.UNSIGNED_SHORT_4_4_4_4&&(ie=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(ie=n.RGB5_A1)}return(ie===n.R16F||ie===n.R32F||ie===n.RG16F||ie===n.RG32F||ie===n.RGBA16F||ie===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function _(N,w){let j;return N?w===null||w===Gi||w===Fr?j=n.DEPTH24_STENCIL8:w===Hi?j=n.DEPTH32F_STENCIL8:w===Xo&&(j=n.DEPTH24_STENCIL8,je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Gi||w===Fr?j=n.DEPTH_COMPONENT24:w===Hi?j=n.DEPTH_COMPONENT32F:w===Xo&&(j=n.DEPTH_COMPONENT16),j}function v(N,w){return C(N)===!0||N.isFramebufferTexture&&N.minFilter!==_n&&N.minFilter!==Kn?Math.log2(Math.max(w.width,w.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?w.mipmaps.length:1}function D(N){let w=new WeakRef(N);i.get(N).__ref=w,g.add(w),x.register(N,w,w)}function P(N){let w=i.get(N).__ref;w!==void 0&&(g.delete(w),x.unregister(w))}function I(N){O(N.target)}function L(N){R(N.target)}function O(N){N.removeEventListener("dispose",I),P(N),k(N),N.isVideoTexture&&h.delete(N),N.isHTMLTexture&&d.delete(N)}function R(N){N.removeEventListener("dispose",L),P(N),$(N)}function U(){for(let N of g){let w=N.deref();w!==void 0&&(w.isRenderTarget===!0?R(w):O(w))}g.clear(),d.clear()}function k(N){let w=i.get(N);if(w.__webglInit===void 0)return;let j=N.source,pe=m.get(j);if(pe){let he=pe[w.__cacheKey];he.usedTimes--,he.usedTimes===0&&z(N),Object.keys(pe).length===0&&m.delete(j)}i.remove(N)}function z(N){let w=i.get(N);n.deleteTexture(w.__webglTexture);let j=N.source,pe=m.get(j);delete pe[w.__cacheKey],o.memory.textures--}function $(N){let w=i.get(N);w.__depthDisposeCallback&&w.__depthDisposeCallback();let j=N.depthTexture;if(j&&j.renderTarget===N&&O(j),N.isWebGLCubeRenderTarget)for(let he=0;he<6;he++){if(Array.isArray(w.__webglFramebuffer[he]))for(let ve=0;ve<w.__webglFramebuffer[he].length;ve++)n.deleteFramebuffer(w.__webglFramebuffer[he][ve]);else n.deleteFramebuffer(w.__webglFramebuffer[he]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[he])}else{if(Array.isArray(w.__webglFramebuffer))for(let he=0;he<w.__webglFramebuffer.length;he++)n.deleteFramebuffer(w.__webglFramebuffer[he]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let he=0;he<w.__webglColorRenderbuffer.length;he++)w.__webglColorRenderbuffer[he]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[he]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let pe=N.textures;for(let he=0,ve=pe.length;he<ve;he++){let Se=i.get(pe[he]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(pe[he])}i.remove(N)}let X=0;function Z(){X=0}function te(){return X}function oe(N){X=N}function ce(){let N=X;return N>=s.maxTextures&&je("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,N}function Q(N){let w=[];return w.push(N.wrapS),w.push(N.wrapT),w.push(N.wrapR||0),w.push(N.magFilter),w.push(N.minFilter),w.push(N.anisotropy),w.push(N.internalFormat),w.push(N.format),w.push(N.type),w.push(N.generateMipmaps),w.push(N.mipmapsAutoUpdate),w.push(N.premultiplyAlpha),w.push(N.flipY),w.push(N.unpackAlignment),w.push(N.colorSpace),w.join()}function me(N,w){let j=i.get(N);if(N.isVideoTexture&&zt(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&j.__version!==N.version){let pe=N.image;if(pe===null)je("WebGLRenderer: Texture marked for update but no image data found.");else if(pe.complete===!1)je("WebGLRenderer: Texture marked for update but image is incomplete");else{Mt(j,N,w);return}}else N.isExternalTexture&&(j.__webglTexture=N.sourceTexture?N.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+w)}function _e(N,w){let j=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&j.__version!==N.version){Mt(j,N,w);return}else N.isExternalTexture&&(j.__webglTexture=N.sourceTexture?N.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+w)}function ae(N,w){let j=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&j.__version!==N.version){Mt(j,N,w);return}t.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+w)}function de(N,w){let j=i.get(N);if(N.version>0&&j.__version!==N.version){jt(j,N,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+w)}let Ne={[Ec]:n.REPEAT,[is]:n.CLAMP_TO_EDGE,[Tc]:n.MIRRORED_REPEAT},Ye={[_n]:n.NEAREST,[L0]:n.NEAREST_MIPMAP_NEAREST,[el]:n.NEAREST_MIPMAP_LINEAR,[Kn]:n.LINEAR,[ih]:n.LINEAR_MIPMAP_NEAREST,[Cs]:n.LINEAR_MIPMAP_LINEAR},Be={[F0]:n.NEVER,[df]:n.ALWAYS,[O0]:n.LESS,[hf]:n.LEQUAL,[B0]:n.EQUAL,[uf]:n.GEQUAL,[z0]:n.GREATER,[k0]:n.NOTEQUAL};function st(N,w){if(w.type===Hi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Kn||w.magFilter===ih||w.magFilter===el||w.magFilter===Cs||w.minFilter===Kn||w.minFilter===ih||w.minFilter===el||w.minFilter===Cs)&&je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(N,n.TEXTURE_WRAP_S,Ne[w.wrapS]),n.texParameteri(N,n.TEXTURE_WRAP_T,Ne[w.wrapT]),(N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY)&&n.texParameteri(N,n.TEXTURE_WRAP_R,Ne[w.wrapR]),n.texParameteri(N,n.TEXTURE_MAG_FILTER,Ye[w.magFilter]),n.texParameteri(N,n.TEXTURE_MIN_FILTER,Ye[w.minFilter]),w.compareFunction&&(n.texParameteri(N,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(N,n.TEXTURE_COMPARE_FUNC,Be[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===_n||w.minFilter!==el&&w.minFilter!==Cs||w.type===Hi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let j=e.get("EXT_texture_filter_anisotropic");n.texParameterf(N,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function at(N,w){let j=!1;N.__webglInit===void 0&&(N.__webglInit=!0,w.addEventListener("dispose",I),D(w));let pe=w.source,he=m.get(pe);he===void 0&&(he={},m.set(pe,he));let ve=Q(w);if(ve!==N.__cacheKey){he[ve]===void 0&&(he[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),he[ve].usedTimes++;let Se=he[N.__cacheKey];Se!==void 0&&(he[N.__cacheKey].usedTimes--,Se.usedTimes===0&&z(w)),N.__cacheKey=ve,N.__webglTexture=he[ve].texture}return j}function $e(N,w,j){return Math.floor(Math.floor(N/j)/w)}function pt(N,w,j,pe){let ve=N.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,j,pe,w.data);else{ve.sort((V,le)=>V.start-le.start);let Se=0;for(let V=1;V<ve.length;V++){let le=ve[Se],se=ve[V],Te=le.start+le.count,ye=$e(se.start,w.width,4),we=$e(le.start,w.width,4);se.start<=Te+1&&ye===we&&$e(se.start+se.count-1,w.width,4)===ye?le.count=Math.max(le.count,se.start+se.count-le.start):(++Se,ve[Se]=se)}ve.length=Se+1;let ie=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),xe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let V=0,le=ve.length;V<le;V++){let se=ve[V],Te=Math.floor(se.start/4),ye=Math.ceil(se.count/4),we=Te%w.width,Xe=Math.floor(Te/w.width),et=ye,fe=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,we,Xe,et,fe,j,pe,w.data)}N.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ie),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,xe)}}function Mt(N,w,j){let pe=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(pe=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(pe=n.TEXTURE_3D);let he=at(N,w),ve=w.source;t.bindTexture(pe,N.__webglTexture,n.TEXTURE0+j);let Se=i.get(ve);if(ve.version!==Se.__version||he===!0){if(t.activeTexture(n.TEXTURE0+j),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let fe=St.getPrimaries(St.workingColorSpace),Ve=w.colorSpace===Is?null:St.getPrimaries(w.colorSpace),tt=w.colorSpace===Is||fe===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let re=M(w.image,!1,s.maxTextureSize);re=We(w,re);let xe=r.convert(w.format,w.colorSpace),V=r.convert(w.type),le=b(w.internalFormat,xe,V,w.normalized,w.colorSpace,w.isVideoTexture);st(pe,w);let se,Te=w.mipmaps,ye=w.isVideoTexture!==!0,we=Se.__version===void 0||he===!0,Xe=ve.dataReady,et=v(w,re);if(w.isDepthTexture)le=_(w.format===Ps,w.type),we&&(ye?t.texStorage2D(n.TEXTURE_2D,1,le,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,le,re.width,re.height,0,xe,V,null));else if(w.isDataTexture)if(Te.length>0){ye&&we&&t.texStorage2D(n.TEXTURE_2D,et,le,Te[0].width,Te[0].height);for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],ye?Xe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,V,se.data):t.texImage2D(n.TEXTURE_2D,fe,le,se.width,se.height,0,xe,V,se.data);w.generateMipmaps=!1}else ye?(we&&t.texStorage2D(n.TEXTURE_2D,et,le,re.width,re.height),Xe&&pt(w,re,xe,V)):t.texImage2D(n.TEXTURE_2D,0,le,re.width,re.height,0,xe,V,re.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){ye&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,le,Te[0].width,Te[0].height,re.depth);for(let fe=0,Ve=Te.length;fe<Ve;fe++)if(se=Te[fe],w.format!==Xi)if(xe!==null)if(ye){if(Xe)if(w.layerUpdates.size>0){let tt=Mf(se.width,se.height,w.format,w.type);for(let Ce of w.layerUpdates){let ut=se.data.subarray(Ce*tt/se.data.BYTES_PER_ELEMENT,(Ce+1)*tt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,Ce,se.width,se.height,1,xe,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,xe,se.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,fe,le,se.width,se.height,re.depth,0,se.data,0,0);else je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,xe,V,se.data):t.texImage3D(n.TEXTURE_2D_ARRAY,fe,le,se.width,se.height,re.depth,0,xe,V,se.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{ye&&we&&t.texStorage2D(n.TEXTURE_2D,et,le,Te[0].width,Te[0].height);for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],w.format!==Xi?xe!==null?ye?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,se.data):t.compressedTexImage2D(n.TEXTURE_2D,fe,le,se.width,se.height,0,se.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?Xe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,V,se.data):t.texImage2D(n.TEXTURE_2D,fe,le,se.width,se.height,0,xe,V,se.data)}else if(w.isDataArrayTexture)if(ye){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,le,re.width,re.height,re.depth),Xe)if(w.layerUpdates.size>0){let fe=Mf(re.width,re.height,w.format,w.type);for(let Ve of w.layerUpdates){let tt=re.data.subarray(Ve*fe/re.data.BYTES_PER_ELEMENT,(Ve+1)*fe/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,re.width,re.height,1,xe,V,tt)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,xe,V,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,le,re.width,re.height,re.depth,0,xe,V,re.data);else if(w.isData3DTexture)ye?(we&&t.texStorage3D(n.TEXTURE_3D,et,le,re.width,re.height,re.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,xe,V,re.data)):t.texImage3D(n.TEXTURE_3D,0,le,re.width,re.height,re.depth,0,xe,V,re.data);else if(w.isFramebufferTexture){if(we)if(ye)t.texStorage2D(n.TEXTURE_2D,et,le,re.width,re.height);else{let fe=re.width,Ve=re.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,le,fe,Ve,0,xe,V,null),fe>>=1,Ve>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let fe=n.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),re.parentNode!==fe){fe.appendChild(re),d.add(w),fe.onpaint=Ve=>{let tt=Ve.changedElements;for(let Ce of d)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},fe.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let tt=n.RGBA,Ce=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Ce,ut,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(ye&&we){let fe=Ze(Te[0]);t.texStorage2D(n.TEXTURE_2D,et,le,fe.width,fe.height)}for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],ye?Xe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,xe,V,se):t.texImage2D(n.TEXTURE_2D,fe,le,xe,V,se);w.generateMipmaps=!1}else if(ye){if(we){let fe=Ze(re);t.texStorage2D(n.TEXTURE_2D,et,le,fe.width,fe.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,xe,V,re)}else t.texImage2D(n.TEXTURE_2D,0,le,xe,V,re);C(w)&&w.mipmapsAutoUpdate===!0&&y(pe),Se.__version=ve.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function jt(N,w,j){if(w.image.length!==6)return;let pe=at(N,w),he=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,N.__webglTexture,n.TEXTURE0+j);let ve=i.get(he);if(he.version!==ve.__version||pe===!0){t.activeTexture(n.TEXTURE0+j);let Se=St.getPrimaries(St.workingColorSpace),ie=w.colorSpace===Is?null:St.getPrimaries(w.colorSpace),re=w.colorSpace===Is||Se===ie?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let xe=w.isCompressedTexture||w.image[0].isCompressedTexture,V=w.image[0]&&w.image[0].isDataTexture,le=[];for(let Ce=0;Ce<6;Ce++)!xe&&!V?le[Ce]=M(w.image[Ce],!0,s.maxCubemapSize):le[Ce]=V?w.image[Ce].image:w.image[Ce],le[Ce]=We(w,le[Ce]);let se=le[0],Te=r.convert(w.format,w.colorSpace),ye=r.convert(w.type),we=b(w.internalFormat,Te,ye,w.normalized,w.colorSpace),Xe=w.isVideoTexture!==!0,et=ve.__version===void 0||pe===!0,fe=he.dataReady,Ve=v(w,se);st(n.TEXTURE_CUBE_MAP,w);let tt;if(w.isDepthTexture){if(we=_(w.format===Ps,w.type),et)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,se.width,se.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,se.width,se.height,0,Te,ye,null)}else if(xe){Xe&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,se.width,se.height);for(let Ce=0;Ce<6;Ce++){tt=le[Ce].mipmaps;for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];w.format!==Xi?Te!==null?Xe?fe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,0,0,Wt.width,Wt.height,Te,Wt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,we,Wt.width,Wt.height,0,Wt.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,0,0,Wt.width,Wt.height,Te,ye,Wt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,we,Wt.width,Wt.height,0,Te,ye,Wt.data)}}}else{if(tt=w.mipmaps,Xe&&et){tt.length>0&&Ve++;let Ce=Ze(le[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(V){Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,le[Ce].width,le[Ce].height,Te,ye,le[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,le[Ce].width,le[Ce].height,0,Te,ye,le[Ce].data);for(let ut=0;ut<tt.length;ut++){let Gn=tt[ut].image[Ce].image;Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,0,0,Gn.width,Gn.height,Te,ye,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,we,Gn.width,Gn.height,0,Te,ye,Gn.data)}}else{Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,ye,le[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,Te,ye,le[Ce]);for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];Xe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,0,0,Te,ye,Wt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,we,Te,ye,Wt.image[Ce])}}}C(w)&&w.mipmapsAutoUpdate===!0&&y(n.TEXTURE_CUBE_MAP),ve.__version=he.version,w.onUpdate&&w.onUpdate(w)}N.__version=w.version}function Ct(N,w,j,pe,he,ve){let Se=r.convert(j.format,j.colorSpace),ie=r.convert(j.type),re=b(j.internalFormat,Se,ie,j.normalized,j.colorSpace),xe=i.get(w),V=i.get(j);if(V.__renderTarget=w,!xe.__hasExternalTextures){let le=Math.max(1,w.width>>ve),se=Math.max(1,w.height>>ve);he===n.TEXTURE_3D||he===n.TEXTURE_2D_ARRAY?t.texImage3D(he,ve,re,le,se,w.depth,0,Se,ie,null):t.texImage2D(he,ve,re,le,se,0,Se,ie,null)}t.bindFramebuffer(n.FRAMEBUFFER,N),Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,he,V.__webglTexture,0,lt(w)):(he===n.TEXTURE_2D||he>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&he<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,pe,he,V.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function rn(N,w,j){if(n.bindRenderbuffer(n.RENDERBUFFER,N),w.depthBuffer){let pe=w.depthTexture,he=pe&&pe.isDepthTexture?pe.type:null,ve=_(w.stencilBuffer,he),Se=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(w),ve,w.width,w.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(w),ve,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ve,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,N)}else{let pe=w.textures;for(let he=0;he<pe.length;he++){let ve=pe[he],Se=r.convert(ve.format,ve.colorSpace),ie=r.convert(ve.type),re=b(ve.internalFormat,Se,ie,ve.normalized,ve.colorSpace);Ee(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(w),re,w.width,w.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(w),re,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,re,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(N,w,j){let pe=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,N),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let he=i.get(w.depthTexture);he.__renderTarget=w;let ve=pe?w.depthTexture.image[0]:w.depthTexture.image;(!he.__webglTexture||ve.width!==w.width||ve.height!==w.height)&&(ve.width=w.width,ve.height=w.height,w.depthTexture.needsUpdate=!0),pe?de(w.depthTexture,0):me(w.depthTexture,0);let Se=he.__webglTexture,ie=lt(w),re=pe?n.TEXTURE_CUBE_MAP_POSITIVE_X+j:n.TEXTURE_2D,xe=w.depthTexture.format===Ps?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ts)Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,xe,re,Se,0);else if(w.depthTexture.format===Ps)Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,xe,re,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(N){let w=i.get(N),j=N.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==N.depthTexture){let pe=N.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),pe){let he=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,pe.removeEventListener("dispose",he)};pe.addEventListener("dispose",he),w.__depthDisposeCallback=he}w.__boundDepthTexture=pe}if(N.depthTexture&&!w.__autoAllocateDepthBuffer)if(j)for(let pe=0;pe<6;pe++)bt(w.__webglFramebuffer[pe],N,pe);else N.texture.mipmaps.length>0?bt(w.__webglFramebuffer[0],N,0):bt(w.__webglFramebuffer,N,0);else if(j){w.__webglDepthbuffer=[];for(let pe=0;pe<6;pe++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[pe]),w.__webglDepthbuffer[pe]===void 0)w.__webglDepthbuffer[pe]=n.createRenderbuffer(),rn(w.__webglDepthbuffer[pe],N,!1);else{let he=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer[pe];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,he,n.RENDERBUFFER,ve)}}else if(N.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),rn(w.__webglDepthbuffer,N,!1);else{let he=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,he,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Qt(N,w,j){let pe=i.get(N);w!==void 0&&Ct(pe.__webglFramebuffer,N,N.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&xn(N)}function ln(N){let w=N.texture,j=i.get(N),pe=i.get(w);N.addEventListener("dispose",L),D(N);let he=N.textures,ve=N.isWebGLCubeRenderTarget===!0,Se=he.length>1;if(Se||(pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture()),pe.__version=w.version,o.memory.textures++),ve){j.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(w.mipmaps.length>0){j.__webglFramebuffer[ie]=[];for(let re=0;re<w.mipmaps.length;re++)j.__webglFramebuffer[ie][re]=n.createFramebuffer()}else j.__webglFramebuffer[ie]=n.createFramebuffer()}else{if(w.mipmaps.length>0){j.__webglFramebuffer=[];for(let ie=0;ie<w.mipmaps.length;ie++)j.__webglFramebuffer[ie]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(Se)for(let ie=0,re=he.length;ie<re;ie++){let xe=i.get(he[ie]);xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture(),o.memory.textures++)}if(N.samples>0&&Ee(N)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let ie=0;ie<he.length;ie++){let re=he[ie];j.__webglColorRenderbuffer[ie]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[ie]);let xe=r.convert(re.format,re.colorSpace),V=r.convert(re.type),le=b(re.internalFormat,xe,V,re.normalized,re.colorSpace,N.isXRRenderTarget===!0),se=lt(N);n.renderbufferStorageMultisample(n.RENDERBUFFER,se,le,N.width,N.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ie,n.RENDERBUFFER,j.__webglColorRenderbuffer[ie])}n.bindRenderbuffer(n.RENDERBUFFER,null),N.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),rn(j.__webglDepthRenderbuffer,N,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,pe.__webglTexture),st(n.TEXTURE_CUBE_MAP,w);for(let ie=0;ie<6;ie++)if(w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Ct(j.__webglFramebuffer[ie][re],N,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Ct(j.__webglFramebuffer[ie],N,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);C(w)?y(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ie=0,re=he.length;ie<re;ie++){let xe=he[ie],V=i.get(xe),le=n.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(le=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(le,V.__webglTexture),st(le,xe),Ct(j.__webglFramebuffer,N,xe,n.COLOR_ATTACHMENT0+ie,le,0),C(xe)&&y(le)}t.unbindTexture()}else{let ie=n.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(ie=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ie,pe.__webglTexture),st(ie,w),w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Ct(j.__webglFramebuffer[re],N,w,n.COLOR_ATTACHMENT0,ie,re);else Ct(j.__webglFramebuffer,N,w,n.COLOR_ATTACHMENT0,ie,0);C(w)?y(ie):w.mipmaps.length>0&&n.texParameteri(ie,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}N.depthBuffer&&xn(N)}function G(N){let w=N.textures;for(let j=0,pe=w.length;j<pe;j++){let he=w[j];if(C(he)&&he.mipmapsAutoUpdate===!0){let ve=T(N),Se=i.get(he).__webglTexture;t.bindTexture(ve,Se),y(ve),t.unbindTexture()}}}let Pe=[];function Je(N){if(N.samples>0){if(Ee(N)===!1){let w=N.textures,j=N.width,pe=N.height,he=n.COLOR_BUFFER_BIT,ve=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(N),ie=w.length>1;if(ie)for(let xe=0;xe<w.length;xe++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let xe=0;xe<w.length;xe++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(he|=n.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(he|=n.STENCIL_BUFFER_BIT)),ie){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[xe]);let V=i.get(w[xe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,j,pe,0,0,j,pe,he,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+xe),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Pe.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ie)for(let xe=0;xe<w.length;xe++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,Se.__webglColorRenderbuffer[xe]);let V=i.get(w[xe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,V,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&l){let w=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function lt(N){return Math.min(s.maxSamples,N.samples)}function Ee(N){let w=i.get(N);return N.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function zt(N){let w=o.render.frame;h.get(N)!==w&&(h.set(N,w),N.update())}function We(N,w){let j=N.colorSpace,pe=N.format,he=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||j!==Ea&&j!==Is&&(St.getTransfer(j)===Lt?(pe!==Xi||he!==si)&&je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",j)),w}function Ze(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=ce,this.resetTextureUnits=Z,this.getTextureUnits=te,this.setTextureUnits=oe,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=ae,this.setTextureCube=de,this.rebindTextures=Qt,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Ct,this.useMultisampledRTT=Ee,this.dispose=U}function CE(n,e){function t(i,s=Is){let r,o=St.getTransfer(s);if(i===si)return n.UNSIGNED_BYTE;if(i===rh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===oh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===rf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===of)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===nf)return n.BYTE;if(i===sf)return n.SHORT;if(i===Xo)return n.UNSIGNED_SHORT;if(i===sh)return n.INT;if(i===Gi)return n.UNSIGNED_INT;if(i===Hi)return n.FLOAT;if(i===Wi)return n.HALF_FLOAT;if(i===af)return n.ALPHA;if(i===lf)return n.RGB;if(i===Xi)return n.RGBA;if(i===Ts)return n.DEPTH_COMPONENT;if(i===Ps)return n.DEPTH_STENCIL;if(i===cf)return n.RED;if(i===ah)return n.RED_INTEGER;if(i===rr)return n.RG;if(i===lh)return n.RG_INTEGER;if(i===ch)return n.RGBA_INTEGER;if(i===tl||i===nl||i===il||i===sl)if(o===Lt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===tl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===sl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===tl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===nl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===il)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===sl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===hh||i===uh||i===dh||i===fh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===hh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===uh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===dh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===fh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ph||i===mh||i===gh||i===_h||i===xh||i===rl||i===yh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===ph||i===mh)return o===Lt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===gh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===_h)return r.COMPRESSED_R11_EAC;if(i===xh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===rl)return r.COMPRESSED_RG11_EAC;if(i===yh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===vh||i===Sh||i===Mh||i===bh||i===wh||i===Eh||i===Th||i===Ah||i===Rh||i===Ch||i===Ph||i===Ih||i===Lh||i===Dh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===vh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Sh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Mh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===bh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Eh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Th)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ah)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Rh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ch)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ph)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ih)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Lh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Dh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Nh||i===Uh||i===Fh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Nh)return o===Lt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Fh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Oh||i===Bh||i===ol||i===zh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Oh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Bh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ol)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===zh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Fr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var PE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,IE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ff=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Ba(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ti({vertexShader:PE,fragmentShader:IE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new kn(new Lr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Of=class extends zi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,m=null,g=null,x=typeof XRWebGLBinding<"u",f=new Ff,p={},M=t.getContextAttributes(),C=null,y=null,T=[],b=[],_=new Ke,v=null,D=null,P=new jn;P.viewport=new Dt;let I=new jn;I.viewport=new Dt;let L=[P,I],O=new Qc,R=null,U=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=T[Q];return me===void 0&&(me=new Oo,T[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=T[Q];return me===void 0&&(me=new Oo,T[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=T[Q];return me===void 0&&(me=new Oo,T[Q]=me),me.getHandSpace()};function k(Q){let me=b.indexOf(Q.inputSource);if(me===-1)return;let _e=T[me];_e!==void 0&&(_e.update(Q.inputSource,Q.frame,c||o),_e.dispatchEvent({type:Q.type,data:Q.inputSource}))}function z(){s.removeEventListener("select",k),s.removeEventListener("selectstart",k),s.removeEventListener("selectend",k),s.removeEventListener("squeeze",k),s.removeEventListener("squeezestart",k),s.removeEventListener("squeezeend",k),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",$);for(let Q=0;Q<T.length;Q++){let me=b[Q];me!==null&&(b[Q]=null,T[Q].disconnect(me))}R=null,U=null,f.reset();for(let Q in p)delete p[Q];if(e.setRenderTarget(C),m=null,u=null,d=null,s=null,y=null,ce.stop(),i.isPresenting=!1,e.setPixelRatio(v),e.setSize(_.width,_.height,!1),D!==null){let Q=D.camera;Q.fov=D.fov,Q.zoom=D.zoom,Q.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return u!==null?u:m},this.getBinding=function(){return d===null&&x&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",k),s.addEventListener("selectstart",k),s.addEventListener("selectend",k),s.addEventListener("squeeze",k),s.addEventListener("squeezestart",k),s.addEventListener("squeezeend",k),s.addEventListener("end",z),s.addEventListener("inputsourceschange",$),M.xrCompatible!==!0&&await t.makeXRCompatible(),v=e.getPixelRatio(),e.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,ae=null,de=null;M.depth&&(de=M.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=M.stencil?Ps:Ts,ae=M.stencil?Fr:Gi);let Ne={colorFormat:t.RGBA8,depthFormat:de,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Ne),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),y=new _i(u.textureWidth,u.textureHeight,{format:Xi,type:si,depthTexture:new Rs(u.textureWidth,u.textureHeight,ae,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:M.stencil,colorSpace:e.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _e={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),y=new _i(m.framebufferWidth,m.framebufferHeight,{format:Xi,type:si,colorSpace:e.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ce.setContext(s),ce.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return f.getDepthTexture()};function $(Q){for(let me=0;me<Q.removed.length;me++){let _e=Q.removed[me],ae=b.indexOf(_e);ae>=0&&(b[ae]=null,T[ae].disconnect(_e))}for(let me=0;me<Q.added.length;me++){let _e=Q.added[me],ae=b.indexOf(_e);if(ae===-1){for(let Ne=0;Ne<T.length;Ne++)if(Ne>=b.length){b.push(_e),ae=Ne;break}else if(b[Ne]===null){b[Ne]=_e,ae=Ne;break}if(ae===-1)break}let de=T[ae];de&&de.connect(_e)}}function X(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,_e=Q.far;f.texture!==null&&(f.depthNear>0&&(me=f.depthNear),f.depthFar>0&&(_e=f.depthFar)),O.near=I.near=P.near=me,O.far=I.far=P.far=_e,(R!==O.near||U!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),R=O.near,U=O.far),O.layers.mask=Q.layers.mask|6,P.layers.mask=O.layers.mask&-5,I.layers.mask=O.layers.mask&-3;let ae=Q.parent,de=O.cameras;X(O,ae);for(let Ne=0;Ne<de.length;Ne++)X(de[Ne],ae);O.projectionMatrix.copy(P.projectionMatrix),O.projectionMatrixInverse.copy(P.projectionMatrixInverse),D===null&&Q.isPerspectiveCamera&&(D={camera:Q,fov:Q.fov,zoom:Q.zoom}),Z(Q,O,ae)};function Z(Q,me,_e){_e===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(_e.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Uo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(u===null&&m===null))return l},this.setFoveation=function(Q){l=Q,u!==null&&(u.fixedFoveation=Q),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=Q)},this.hasDepthSensing=function(){return f.texture!==null},this.getDepthSensingMesh=function(){return f.getMesh(O)},this.getCameraTexture=function(Q){return p[Q]};let te=null;function oe(Q,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let _e=h.views;m!==null&&(e.setRenderTargetFramebuffer(y,m.framebuffer),e.setRenderTarget(y));let ae=!1;_e.length!==O.cameras.length&&(O.cameras.length=0,ae=!0);for(let Be=0;Be<_e.length;Be++){let st=_e[Be],at=null;if(m!==null)at=m.getViewport(st);else{let pt=d.getViewSubImage(u,st);at=pt.viewport,Be===0&&(e.setRenderTargetTextures(y,pt.colorTexture,pt.depthStencilTexture),e.setRenderTarget(y))}let $e=L[Be];$e===void 0&&($e=new jn,$e.layers.enable(Be),$e.viewport=new Dt,L[Be]=$e),$e.matrix.fromArray(st.transform.matrix),$e.matrix.decompose($e.position,$e.quaternion,$e.scale),$e.projectionMatrix.fromArray(st.projectionMatrix),$e.projectionMatrixInverse.copy($e.projectionMatrix).invert(),$e.viewport.set(at.x,at.y,at.width,at.height),Be===0&&(O.matrix.copy($e.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),ae===!0&&O.cameras.push($e)}let de=s.enabledFeatures;if(de&&de.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){d=i.getBinding();let Be=d.getDepthInformation(_e[0]);Be&&Be.isValid&&Be.texture&&f.init(Be,s.renderState)}if(de&&de.includes("camera-access")&&x){e.state.unbindTexture(),d=i.getBinding();for(let Be=0;Be<_e.length;Be++){let st=_e[Be].camera;if(st){let at=p[st];at||(at=new Ba,p[st]=at);let $e=d.getCameraImage(st);at.sourceTexture=$e}}}}for(let _e=0;_e<T.length;_e++){let ae=b[_e],de=T[_e];ae!==null&&de!==void 0&&de.update(ae,me,c||o)}te&&te(Q,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let ce=new m_;ce.setAnimationLoop(oe),this.setAnimationLoop=function(Q){te=Q},this.dispose=function(){}}},LE=new Ot,E_=new rt;E_.set(-1,0,0,0,1,0,0,0,1);function DE(n,e){function t(f,p){f.matrixAutoUpdate===!0&&f.updateMatrix(),p.value.copy(f.matrix)}function i(f,p){p.color.getRGB(f.fogColor.value,yf(n)),p.isFog?(f.fogNear.value=p.near,f.fogFar.value=p.far):p.isFogExp2&&(f.fogDensity.value=p.density)}function s(f,p,M,C,y){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(f,p):p.isMeshLambertMaterial?(r(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(f,p),d(f,p)):p.isMeshPhongMaterial?(r(f,p),h(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(f,p),u(f,p),p.isMeshPhysicalMaterial&&m(f,p,y)):p.isMeshMatcapMaterial?(r(f,p),g(f,p)):p.isMeshDepthMaterial?r(f,p):p.isMeshDistanceMaterial?(r(f,p),x(f,p)):p.isMeshNormalMaterial?r(f,p):p.isLineBasicMaterial?(o(f,p),p.isLineDashedMaterial&&a(f,p)):p.isPointsMaterial?l(f,p,M,C):p.isSpriteMaterial?c(f,p):p.isShadowMaterial?(f.color.value.copy(p.color),f.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(f,p){f.opacity.value=p.opacity,p.color&&f.diffuse.value.copy(p.color),p.emissive&&f.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.bumpMap&&(f.bumpMap.value=p.bumpMap,t(p.bumpMap,f.bumpMapTransform),f.bumpScale.value=p.bumpScale,p.side===ti&&(f.bumpScale.value*=-1)),p.normalMap&&(f.normalMap.value=p.normalMap,t(p.normalMap,f.normalMapTransform),f.normalScale.value.copy(p.normalScale),p.side===ti&&f.normalScale.value.negate()),p.displacementMap&&(f.displacementMap.value=p.displacementMap,t(p.displacementMap,f.displacementMapTransform),f.displacementScale.value=p.displacementScale,f.displacementBias.value=p.displacementBias),p.emissiveMap&&(f.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,f.emissiveMapTransform)),p.specularMap&&(f.specularMap.value=p.specularMap,t(p.specularMap,f.specularMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest);let M=e.get(p),C=M.envMap,y=M.envMapRotation;C&&(f.envMap.value=C,f.envMapRotation.value.setFromMatrix4(LE.makeRotationFromEuler(y)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&f.envMapRotation.value.premultiply(E_),f.reflectivity.value=p.reflectivity,f.ior.value=p.ior,f.refractionRatio.value=p.refractionRatio),p.lightMap&&(f.lightMap.value=p.lightMap,f.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,f.lightMapTransform)),p.aoMap&&(f.aoMap.value=p.aoMap,f.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,f.aoMapTransform))}function o(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform))}function a(f,p){f.dashSize.value=p.dashSize,f.totalSize.value=p.dashSize+p.gapSize,f.scale.value=p.scale}function l(f,p,M,C){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.size.value=p.size*M,f.scale.value=C*.5,p.map&&(f.map.value=p.map,t(p.map,f.uvTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function c(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.rotation.value=p.rotation,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function h(f,p){f.specular.value.copy(p.specular),f.shininess.value=Math.max(p.shininess,1e-4)}function d(f,p){p.gradientMap&&(f.gradientMap.value=p.gradientMap)}function u(f,p){f.metalness.value=p.metalness,p.metalnessMap&&(f.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,f.metalnessMapTransform)),f.roughness.value=p.roughness,p.roughnessMap&&(f.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,f.roughnessMapTransform)),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)}function m(f,p,M){f.ior.value=p.ior,p.diffuseRoughness>0&&(f.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(f.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,f.diffuseRoughnessMapTransform))),p.sheen>0&&(f.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),f.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(f.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,f.sheenColorMapTransform)),p.sheenRoughnessMap&&(f.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,f.sheenRoughnessMapTransform))),p.clearcoat>0&&(f.clearcoat.value=p.clearcoat,f.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(f.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,f.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(f.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,f.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(f.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,f.clearcoatNormalMapTransform),f.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ti&&f.clearcoatNormalScale.value.negate())),p.dispersion>0&&(f.dispersion.value=p.dispersion),p.retroreflectivity>0&&(f.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(f.iridescence.value=p.iridescence,f.iridescenceIOR.value=p.iridescenceIOR,f.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,f.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(f.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,f.iridescenceMapTransform)),p.iridescenceThicknessMap&&(f.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,f.iridescenceThicknessMapTransform))),p.transmission>0&&(f.transmission.value=p.transmission,f.transmissionSamplerMap.value=M.texture,f.transmissionSamplerSize.value.set(M.width,M.height),p.transmissionMap&&(f.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,f.transmissionMapTransform)),f.thickness.value=p.thickness,p.thicknessMap&&(f.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,f.thicknessMapTransform)),f.attenuationDistance.value=p.attenuationDistance,f.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(f.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(f.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,f.anisotropyMapTransform))),f.specularIntensity.value=p.specularIntensity,f.specularColor.value.copy(p.specularColor),p.specularColorMap&&(f.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,f.specularColorMapTransform)),p.specularIntensityMap&&(f.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,f.specularIntensityMapTransform))}function g(f,p){p.matcap&&(f.matcap.value=p.matcap)}function x(f,p){let M=e.get(p).light;f.referencePosition.value.setFromMatrixPosition(M.matrixWorld),f.nearDistance.value=M.shadow.camera.near,f.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function NE(n,e,t,i){let s={},r={};function o(M,C){let y=C.program;i.uniformBlockBinding(M,y,s[M.id])}function a(M,C){let y=s[M.id];y===void 0&&(g(M),y=l(M),s[M.id]=y,M.addEventListener("dispose",f));let T=C.program;i.updateUBOMapping(M,T);let b=e.render.frame;r[M.id]!==b&&(c(M),r[M.id]=b)}function l(M){let C=n.createBuffer(),y=M.__size,T=M.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,y,T),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(M){let C=s[M.id],y=M.uniforms,T=M.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let b=0,_=y.length;b<_;b++){let v=y[b];if(Array.isArray(v))for(let D=0,P=v.length;D<P;D++)h(v[D],b,D,T);else h(v,b,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(M,C,y,T){if(u(M,C,y,T)===!0){let b=M.__offset,_=M.value;if(Array.isArray(_)){let v=0;for(let D=0;D<_.length;D++){let P=_[D],I=x(P,!0);d(P,M.__data,v),v+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,M.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,b,M.__data)}}function d(M,C,y){typeof M=="number"||typeof M=="boolean"?C[y]=M:M.isMatrix3?(C[y]=M.elements[0],C[y+1]=M.elements[1],C[y+2]=M.elements[2],C[y+3]=0,C[y+4]=M.elements[3],C[y+5]=M.elements[4],C[y+6]=M.elements[5],C[y+7]=0,C[y+8]=M.elements[6],C[y+9]=M.elements[7],C[y+10]=M.elements[8],C[y+11]=0):ArrayBuffer.isView(M)?C.set(M.subarray(0,C.length-y),y):M.toArray(C,y)}function u(M,C,y,T){let b=M.value,_=C+"_"+y;if(Array.isArray(b)){T[_]===void 0&&(T[_]=[]);let v=T[_],D=!1;for(let P=0;P<b.length;P++)m(b[P],v,P)===!0&&(D=!0);return D}return m(b,T,_)}function m(M,C,y){if(C[y]===void 0)return typeof M=="number"||typeof M=="boolean"?C[y]=M:ArrayBuffer.isView(M)?C[y]=M.slice():C[y]=M.clone(),!0;{let T=C[y];if(typeof M=="number"||typeof M=="boolean"){if(T!==M)return C[y]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(T.equals(M)===!1)return T.copy(M),!0}}return!1}function g(M){let C=M.uniforms,y=0,T=16;for(let _=0,v=C.length;_<v;_++){let D=Array.isArray(C[_])?C[_]:[C[_]];for(let P=0,I=D.length;P<I;P++){let L=D[P],O=Array.isArray(L.value)?L.value:[L.value],R=Array.isArray(C[_])||Array.isArray(L.value),U=y;for(let z=0,$=O.length;z<$;z++){let X=O[z],Z=x(X,R),te=y%T,oe=te%Z.boundary,ce=te+oe;y+=oe,ce!==0&&T-ce<Z.storage&&(y+=T-ce),z===0&&(U=y),y+=Z.storage}let k=L.type==="int"?Int32Array:L.type==="uint"?Uint32Array:Float32Array;L.__data=new k((y-U)/Float32Array.BYTES_PER_ELEMENT),L.__offset=U}}let b=y%T;return b>0&&(y+=T-b),M.__size=y,M.__cache={},this}function x(M,C){let y={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(y.boundary=4,y.storage=4):M.isVector2?(y.boundary=8,y.storage=8):M.isVector3||M.isColor?(y.boundary=16,y.storage=12):M.isVector4?(y.boundary=16,y.storage=16):M.isMatrix3?(y.boundary=16,y.storage=48):M.isMatrix4?(y.boundary=16,y.storage=64):M.isTexture?je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(y.boundary=16,y.storage=M.byteLength):je("WebGLRenderer: Unsupported uniform value type.",M),C===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function f(M){let C=M.target;C.removeEventListener("dispose",f),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function p(){for(let M in s)n.deleteBuffer(s[M]);s={},r={}}return{bind:o,update:a,dispose:p}}var UE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),as=null;function FE(){return as===null&&(as=new Dc(UE,16,16,rr,Wi),as.name="DFG_LUT",as.minFilter=Kn,as.magFilter=Kn,as.wrapS=is,as.wrapT=is,as.generateMipmaps=!1,as.needsUpdate=!0),as}var Xh=class{constructor(e={}){let{canvas:t=V0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:m=si}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=m,f=new Set([ch,lh,ah]),p=new Set([si,Gi,Xo,Fr,rh,oh]),M=new Uint32Array(4),C=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},T=null,b=null,_=[],v=[],D=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,I=!1,L=null,O=null,R=null,U=null;this._outputColorSpace=Zn;let k=0,z=0,$=null,X=-1,Z=null,te=new Dt,oe=new Dt,ce=null,Q=new ht(0),me=0,_e=t.width,ae=t.height,de=1,Ne=null,Ye=null,Be=new Dt(0,0,_e,ae),st=new Dt(0,0,_e,ae),at=!1,$e=new js,pt=new Nc,Mt=!1,jt=!1,Ct=new Ot,rn=new q,bt=new Dt,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function ln(){return $===null?de:1}let G=i;function Pe(A,W){return t.getContext(A,W)}let Je,lt,Ee,zt,We,Ze,N,w,j,pe,he,ve,Se,ie,re,xe,V,le,se,Te,ye,we,Xe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),G===null){let W="webgl2";if(G=Pe(W,A),G===null)throw Pe(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(A){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),it("WebGLRenderer: "+A.message),A}function et(){Je=new Y1(G),Je.init(),ye=new CE(G,Je),lt=new F1(G,Je,e,ye),Ee=new AE(G,Je),lt.reversedDepthBuffer&&u&&Ee.buffers.depth.setReversed(!0),O=G.createFramebuffer(),R=G.createFramebuffer(),U=G.createFramebuffer(),zt=new j1(G),We=new fE,Ze=new RE(G,Je,Ee,We,lt,ye,zt),N=new q1(P),w=new KS(G),we=new N1(G,w),j=new $1(G,w,zt,we),pe=new K1(G,j,w,we,zt),le=new J1(G,lt,Ze),re=new O1(We),he=new dE(P,N,Je,lt,we,re),ve=new DE(P,We),Se=new mE,ie=new SE(Je),V=new D1(P,N,Ee,pe,g,l),xe=new TE(P,pe,lt),Xe=new NE(G,zt,lt,Ee),se=new U1(G,Je,zt),Te=new Z1(G,Je,zt),zt.programs=he.programs,P.capabilities=lt,P.extensions=Je,P.properties=We,P.renderLists=Se,P.shadowMap=xe,P.state=Ee,P.info=zt}x!==si&&(D=new ew(x,t.width,t.height,a,s,r));let fe=new Of(P,G);this.xr=fe,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let A=Je.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Je.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return de},this.setPixelRatio=function(A){A!==void 0&&(de=A,this.setSize(_e,ae,!1))},this.getSize=function(A){return A.set(_e,ae)},this.setSize=function(A,W,ne=!0){if(fe.isPresenting){je("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=A,ae=W,t.width=Math.floor(A*de),t.height=Math.floor(W*de),ne===!0&&(t.style.width=A+"px",t.style.height=W+"px"),D!==null&&D.setSize(t.width,t.height),this.setViewport(0,0,A,W)},this.getDrawingBufferSize=function(A){return A.set(_e*de,ae*de).floor()},this.setDrawingBufferSize=function(A,W,ne){_e=A,ae=W,de=ne,t.width=Math.floor(A*ne),t.height=Math.floor(W*ne),this.setViewport(0,0,A,W)},this.setEffects=function(A){if(x===si){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let W=0;W<A.length;W++)if(A[W].isOutputPass===!0){je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(te)},this.getViewport=function(A){return A.copy(Be)},this.setViewport=function(A,W,ne,J){A.isVector4?Be.set(A.x,A.y,A.z,A.w):Be.set(A,W,ne,J),Ee.viewport(te.copy(Be).multiplyScalar(ln()).round())},this.getScissor=function(A){return A.copy(st)},this.setScissor=function(A,W,ne,J){A.isVector4?st.set(A.x,A.y,A.z,A.w):st.set(A,W,ne,J),Ee.scissor(oe.copy(st).multiplyScalar(ln()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(A){Ee.setScissorTest(at=A)},this.setOpaqueSort=function(A){Ne=A},this.setTransparentSort=function(A){Ye=A},this.getClearColor=function(A){return A.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(A=!0,W=!0,ne=!0){let J=0;if(A){let K=!1;if($!==null){let Ae=$.texture.format;K=f.has(Ae)}if(K){let Ae=$.texture.type,Le=p.has(Ae),Re=V.getClearColor(),De=V.getClearAlpha(),He=Re.r,nt=Re.g,gt=Re.b;Le?(M[0]=He,M[1]=nt,M[2]=gt,M[3]=De,G.clearBufferuiv(G.COLOR,0,M)):(C[0]=He,C[1]=nt,C[2]=gt,C[3]=De,G.clearBufferiv(G.COLOR,0,C))}else J|=G.COLOR_BUFFER_BIT}W&&(J|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&(J|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&G.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),L=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),V.dispose(),Se.dispose(),ie.dispose(),Ze.dispose(),We.dispose(),N.dispose(),pe.dispose(),j.dispose(),we.dispose(),Xe.dispose(),he.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",ml),fe.removeEventListener("sessionend",qi),ds.stop()};function Ve(A){A.preventDefault(),Ra("WebGLRenderer: Context Lost."),I=!0}function tt(){Ra("WebGLRenderer: Context Restored."),I=!1;let A=zt.autoReset,W=xe.enabled,ne=xe.autoUpdate,J=xe.needsUpdate,K=xe.type;et(),zt.autoReset=A,xe.enabled=W,xe.autoUpdate=ne,xe.needsUpdate=J,xe.type=K}function Ce(A){it("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ut(A){let W=A.target;W.removeEventListener("dispose",ut),Wt(W)}function Wt(A){Gn(A),We.remove(A)}function Gn(A){let W=We.get(A).programs;W!==void 0&&(W.forEach(function(ne){he.releaseProgram(ne)}),A.isShaderMaterial&&he.releaseShaderCache(A))}this.renderBufferDirect=function(A,W,ne,J,K,Ae){W===null&&(W=xn);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Re=Qo(A,W,ne,J,K);Ee.setMaterial(J,Le);let De=ne.index,He=1;if(J.wireframe===!0){if(De=j.getWireframeAttribute(ne),De===void 0)return;He=2}let nt=ne.drawRange,gt=ne.attributes.position,Ge=nt.start*He,_t=(nt.start+nt.count)*He;Ae!==null&&(Ge=Math.max(Ge,Ae.start*He),_t=Math.min(_t,(Ae.start+Ae.count)*He)),De!==null?(Ge=Math.max(Ge,0),_t=Math.min(_t,De.count)):gt!=null&&(Ge=Math.max(Ge,0),_t=Math.min(_t,gt.count));let Kt=_t-Ge;if(Kt<0||Kt===1/0)return;we.setup(K,J,Re,ne,De);let Nt,Ut=se;if(De!==null&&(Nt=w.get(De),Ut=Te,Ut.setIndex(Nt)),K.isMesh)J.wireframe===!0?(Ee.setLineWidth(J.wireframeLinewidth*ln()),Ut.setMode(G.LINES)):Ut.setMode(G.TRIANGLES);else if(K.isLine){let yn=J.linewidth;yn===void 0&&(yn=1),Ee.setLineWidth(yn*ln()),K.isLineSegments?Ut.setMode(G.LINES):K.isLineLoop?Ut.setMode(G.LINE_LOOP):Ut.setMode(G.LINE_STRIP)}else K.isPoints?Ut.setMode(G.POINTS):K.isSprite&&Ut.setMode(G.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Ut.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let yn=K._multiDrawStarts,ze=K._multiDrawCounts,cn=K._multiDrawCount,yt=De?w.get(De).bytesPerElement:1,ps=We.get(J).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)ps.setValue(G,"_gl_DrawID",hn),Ut.render(yn[hn]/yt,ze[hn])}else if(K.isInstancedMesh)Ut.renderInstances(Ge,Kt,K.count);else if(ne.isInstancedBufferGeometry){let yn=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,ze=Math.min(ne.instanceCount,yn);Ut.renderInstances(Ge,Kt,ze)}else Ut.render(Ge,Kt)};function jo(A,W,ne,J){L!==null&&A.isNodeMaterial&&L.setObject(J,A),Mt===!0&&re.setState(A,ne,!1),A.transparent===!0&&A.side===rs&&A.forceSinglePass===!1?(A.side=ti,A.needsUpdate=!0,Yi(A,W,J),A.side=sr,A.needsUpdate=!0,Yi(A,W,J),A.side=rs):Yi(A,W,J)}this.compile=function(A,W,ne=null){ne===null&&(ne=A),L!==null&&L.renderStart(A,W,ne),b=ie.get(ne),b.init(W),v.push(b),ne.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(b.pushLight(K),K.castShadow&&b.pushShadow(K))}),A!==ne&&A.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(b.pushLight(K),K.castShadow&&b.pushShadow(K))}),b.setupLights(),L!==null&&L.updateLights(b.state.lightsArray),jt=this.localClippingEnabled,Mt=re.init(this.clippingPlanes,jt),Mt===!0&&re.setGlobalState(this.clippingPlanes,W),L!==null&&xe.render(b.state.shadowsArray,ne,W);let J=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ae=K.material;if(Ae)if(Array.isArray(Ae))for(let Le=0;Le<Ae.length;Le++){let Re=Ae[Le];jo(Re,ne,W,K),J.add(Re)}else jo(Ae,ne,W,K),J.add(Ae)}),b=v.pop(),L!==null&&L.renderEnd(),J},this.compileAsync=function(A,W,ne=null){let J=this.compile(A,W,ne);return new Promise(K=>{function Ae(){if(J.forEach(function(Le){let De=We.get(Le).currentProgram;(De===void 0||De.isReady())&&J.delete(Le)}),J.size===0){K(A);return}setTimeout(Ae,10)}Je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Gr=null;function ru(A){Gr&&Gr(A)}function ml(){ds.stop()}function qi(){ds.start()}let ds=new m_;ds.setAnimationLoop(ru),typeof self<"u"&&ds.setContext(self),this.setAnimationLoop=function(A){Gr=A,fe.setAnimationLoop(A),A===null?ds.stop():ds.start()},fe.addEventListener("sessionstart",ml),fe.addEventListener("sessionend",qi),this.render=function(A,W){if(W!==void 0&&W.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;L!==null&&L.renderStart(A,W);let ne=fe.enabled===!0&&fe.isPresenting===!0,J=D!==null&&($===null||ne)&&D.begin(P,$);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(W),W=fe.getCamera()),A.isScene===!0&&A.onBeforeRender(P,A,W,$),b=ie.get(A,v.length),b.init(W),b.state.textureUnits=Ze.getTextureUnits(),v.push(b),Ct.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?pt.setFromArrayCamera(W):$e.setFromProjectionMatrix(Ct,Ei,W.reversedDepth),jt=this.localClippingEnabled,Mt=re.init(this.clippingPlanes,jt),T=Se.get(A,_.length),T.init(),_.push(T),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let Le=P.xr.getDepthSensingMesh();Le!==null&&fs(Le,W,-1/0,P.sortObjects)}fs(A,W,0,P.sortObjects),T.finish(),L!==null&&L.updateLights(b.state.lightsArray),P.sortObjects===!0&&T.sort(Ne,Ye),Qt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,Qt&&V.addToRenderList(T,A),this.info.autoReset===!0&&this.info.reset(),Mt===!0&&re.beginShadows();let K=b.state.shadowsArray;if(xe.render(K,A,W),Mt===!0&&re.endShadows(),(J&&D.hasRenderPass())===!1){let Le=T.opaque,Re=T.transmissive;if(b.setupLights(),W.isArrayCamera){let De=W.cameras;if(Re.length>0)for(let He=0,nt=De.length;He<nt;He++){let gt=De[He];Ai(Le,Re,A,gt)}Qt&&V.render(A);for(let He=0,nt=De.length;He<nt;He++){let gt=De[He];Jo(T,A,gt,gt.viewport)}}else Re.length>0&&Ai(Le,Re,A,W),Qt&&V.render(A),Jo(T,A,W)}$!==null&&z===0&&(Ze.updateMultisampleRenderTarget($),Ze.updateRenderTargetMipmap($)),J&&D.end(P),A.isScene===!0&&A.onAfterRender(P,A,W),we.resetDefaultState(),X=-1,Z=null,v.pop(),v.length>0?(b=v[v.length-1],Ze.setTextureUnits(b.state.textureUnits),Mt===!0&&re.setGlobalState(P.clippingPlanes,b.state.camera)):b=null,_.pop(),_.length>0?T=_[_.length-1]:T=null,L!==null&&L.renderEnd()};function fs(A,W,ne,J){if(A.visible===!1)return;if(A.layers.test(W.layers)){if(A.isGroup)ne=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(W);else if(A.isLight)b.pushLight(A),A.castShadow&&b.pushShadow(A);else if(A.isSprite){let Le=W.isArrayCamera?pt:$e;if(!A.frustumCulled||A.intersectsFrustum(Le)){J&&bt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ct);let Re=pe.update(A),De=A.material;De.visible&&T.push(A,Re,De,ne,bt.z,null,W)}}else if(A.isMesh||A.isLine||A.isPoints){let Le=W.isArrayCamera?pt:$e;if(!A.frustumCulled||A.intersectsFrustum(Le)){let Re=pe.update(A),De=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),bt.copy(A.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),bt.copy(Re.boundingSphere.center)),bt.applyMatrix4(A.matrixWorld).applyMatrix4(Ct)),Array.isArray(De)){let He=Re.groups;for(let nt=0,gt=He.length;nt<gt;nt++){let Ge=He[nt],_t=De[Ge.materialIndex];_t&&_t.visible&&T.push(A,Re,_t,ne,bt.z,Ge,W)}}else De.visible&&T.push(A,Re,De,ne,bt.z,null,W)}}}let Ae=A.children;for(let Le=0,Re=Ae.length;Le<Re;Le++)fs(Ae[Le],W,ne,J)}function Jo(A,W,ne,J){let{opaque:K,transmissive:Ae,transparent:Le}=A;b.setupLightsView(ne),Mt===!0&&re.setGlobalState(P.clippingPlanes,ne),J&&Ee.viewport(te.copy(J)),K.length>0&&en(K,W,ne),Ae.length>0&&en(Ae,W,ne),Le.length>0&&en(Le,W,ne),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ai(A,W,ne,J){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[J.id]===void 0){let Ge=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[J.id]=new _i(1,1,{generateMipmaps:!0,type:Ge?Wi:si,minFilter:Cs,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ae=b.state.transmissionRenderTarget[J.id],Le=J.viewport||te;Ae.setSize(Le.z*P.transmissionResolutionScale,Le.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),De=P.getActiveCubeFace(),He=P.getActiveMipmapLevel();P.setRenderTarget(Ae),P.getClearColor(Q),me=P.getClearAlpha(),me<1&&P.setClearColor(16777215,.5),P.clear(),Qt&&V.render(ne);let nt=P.toneMapping;P.toneMapping=os;let gt=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),b.setupLightsView(J),Mt===!0&&re.setGlobalState(P.clippingPlanes,J),en(A,ne,J),Ze.updateMultisampleRenderTarget(Ae),Ze.updateRenderTargetMipmap(Ae),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let _t=0,Kt=W.length;_t<Kt;_t++){let Nt=W[_t],{object:Ut,geometry:yn,material:ze,group:cn}=Nt;if(ze.side===rs&&Ut.layers.test(J.layers)){let yt=ze.side;ze.side=ti,ze.needsUpdate=!0,on(Ut,ne,J,yn,ze,cn),ze.side=yt,ze.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ze.updateMultisampleRenderTarget(Ae),Ze.updateRenderTargetMipmap(Ae))}P.setRenderTarget(Re,De,He),P.setClearColor(Q,me),gt!==void 0&&(J.viewport=gt),P.toneMapping=nt}function en(A,W,ne){let J=W.isScene===!0?W.overrideMaterial:null;for(let K=0,Ae=A.length;K<Ae;K++){let Le=A[K],{object:Re,geometry:De,group:He}=Le,nt=Le.material;nt.allowOverride===!0&&J!==null&&(nt=J),Re.layers.test(ne.layers)&&on(Re,W,ne,De,nt,He)}}function on(A,W,ne,J,K,Ae){L!==null&&K.isNodeMaterial&&L.setObject(A,K),A.onBeforeRender(P,W,ne,J,K,Ae),A.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(P,W,ne,J,A,Ae),K.transparent===!0&&K.side===rs&&K.forceSinglePass===!1?(K.side=ti,K.needsUpdate=!0,P.renderBufferDirect(ne,W,J,K,A,Ae),K.side=sr,K.needsUpdate=!0,P.renderBufferDirect(ne,W,J,K,A,Ae),K.side=rs):P.renderBufferDirect(ne,W,J,K,A,Ae),A.onAfterRender(P,W,ne,J,K,Ae)}function an(A){let W=0;for(let ne of A)ne.texture!==null&&W++;return W}function Yi(A,W,ne){W.isScene!==!0&&(W=xn);let J=We.get(A),K=b.state.lights,Ae=b.state.shadowsArray,Le=K.state.version,Re=he.getParameters(A,K.state,Ae,W,ne,b.state.lightProbeGridArray),De=he.getProgramCacheKey(Re),He=J.programs;J.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?W.environment:null,J.fog=W.fog;let nt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;J.envMap=N.get(A.envMap||J.environment,nt),J.envMapRotation=J.environment!==null&&A.envMap===null?W.environmentRotation:A.envMapRotation,He===void 0&&(A.addEventListener("dispose",ut),He=new Map,J.programs=He,J.programVariants=new Map);let gt=He.get(De);if(gt!==void 0){if(J.currentProgram===gt&&J.lightsStateVersion===Le)return Ko(A,Re),gt}else Re.uniforms=he.getUniforms(A),L!==null&&A.isNodeMaterial&&L.build(A,ne,Re),A.onBeforeCompile(Re,P),gt=he.acquireProgram(Re,De),He.set(De,gt),J.uniforms=Re.uniforms;let Ge=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ge.clippingPlanes=re.uniform),Ko(A,Re),J.needsLights=Ns(A),J.lightsStateVersion=Le,J.needsLights&&(Ge.ambientLightColor.value=K.state.ambient,Ge.lightProbe.value=K.state.probe,Ge.sunLights.value=K.state.sun,Ge.sunLightShadows.value=K.state.sunShadow,Ge.directionalLights.value=K.state.directional,Ge.directionalLightShadows.value=K.state.directionalShadow,Ge.spotLights.value=K.state.spot,Ge.spotLightShadows.value=K.state.spotShadow,Ge.rectAreaLights.value=K.state.rectArea,Ge.ltc_1.value=K.state.rectAreaLTC1,Ge.ltc_2.value=K.state.rectAreaLTC2,Ge.pointLights.value=K.state.point,Ge.pointLightShadows.value=K.state.pointShadow,Ge.hemisphereLights.value=K.state.hemi,Ge.sunShadowMatrix.value=K.state.sunShadowMatrix,Ge.sunShadowCascade.value=K.state.sunShadowCascade,Ge.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ge.spotLightMatrix.value=K.state.spotLightMatrix,Ge.spotLightMap.value=K.state.spotLightMap,Ge.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=an(b.state.lightProbeGridArray),J.currentProgram=gt,J.uniformsList=null,gt}function oi(A,W,ne,J,K){let Ae=We.get(A),Le=Ae.currentProgram.id+","+J+","+K,Re=Ae.programVariants.get(Le);return Re===void 0?(Re=Yi(A,W,ne),Ae.programVariants.set(Le,Re)):(Ae.currentProgram=Re,Ae.uniformsList=null,Ae.outputColorSpace=J,Ae.toneMapping=K),Re}function Ds(A){if(A.uniformsList===null){let W=A.currentProgram.getUniforms();A.uniformsList=qo.seqWithValue(W.seq,A.uniforms)}return A.uniformsList}function Ko(A,W){let ne=We.get(A);ne.outputColorSpace=W.outputColorSpace,ne.batching=W.batching,ne.batchingColor=W.batchingColor,ne.instancing=W.instancing,ne.instancingColor=W.instancingColor,ne.instancingMorph=W.instancingMorph,ne.skinning=W.skinning,ne.morphTargets=W.morphTargets,ne.morphNormals=W.morphNormals,ne.morphColors=W.morphColors,ne.morphTargetsCount=W.morphTargetsCount,ne.numClippingPlanes=W.numClippingPlanes,ne.numIntersection=W.numClipIntersection,ne.vertexAlphas=W.vertexAlphas,ne.vertexTangents=W.vertexTangents,ne.toneMapping=W.toneMapping}function Qo(A,W,ne,J,K){W.isScene!==!0&&(W=xn),Ze.resetTextureUnits();let Ae=W.fog,Le=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?W.environment:null,Re=$===null?P.outputColorSpace:$.isXRRenderTarget===!0?$.texture.colorSpace:St.workingColorSpace,De=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,He=N.get(J.envMap||Le,De),nt=J.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,gt=!!ne.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Ge=!!ne.morphAttributes.position,_t=!!ne.morphAttributes.normal,Kt=!!ne.morphAttributes.color,Nt=os;J.toneMapped&&($===null||$.isXRRenderTarget===!0)&&(Nt=P.toneMapping);let Ut=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,yn=Ut!==void 0?Ut.length:0,ze=We.get(J),cn=b.state.lights;if(Mt===!0&&(jt===!0||A!==Z)){let Ft=A===Z&&J.id===X;re.setState(J,A,Ft)}let yt=!1,ps=!1;J.version===ze.__version?ze.needsLights&&ze.lightsStateVersion!==cn.state.version||K.isBatchedMesh&&ze.batching===!1||!K.isBatchedMesh&&ze.batching===!0||K.isBatchedMesh&&ze.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&ze.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&ze.instancing===!1||!K.isInstancedMesh&&ze.instancing===!0||K.isSkinnedMesh&&ze.skinning===!1||!K.isSkinnedMesh&&ze.skinning===!0||K.isInstancedMesh&&ze.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&ze.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&ze.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&ze.instancingMorph===!1&&K.morphTexture!==null||ze.envMap!==He||J.fog===!0&&ze.fog!==Ae||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==re.numPlanes||ze.numIntersection!==re.numIntersection)||ze.vertexAlphas!==nt||ze.vertexTangents!==gt||ze.morphTargets!==Ge||ze.morphNormals!==_t||ze.morphColors!==Kt||ze.morphTargetsCount!==yn||ze.numLightProbeGrids!==an(b.state.lightProbeGridArray)?yt=!0:(ze.outputColorSpace!==Re||ze.toneMapping!==Nt)&&(ps=!0):(yt=!0,ze.__version=J.version);let hn=ze.currentProgram;(yt===!0||ps===!0)&&(hn=ps===!0?oi(J,W,K,Re,Nt):Yi(J,W,K),L&&J.isNodeMaterial&&L.onUpdateProgram(J,hn,ze));let Xr=!1,$i=!1,ms=!1,dt=hn.getUniforms(),tn=ze.uniforms;if(Ee.useProgram(hn.program)&&(Xr=!0,$i=!0,ms=!0),J.id!==X&&(X=J.id,$i=!0),Xr||Z!==A){Ee.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),dt.setValue(G,"projectionMatrix",A.projectionMatrix),dt.setValue(G,"viewMatrix",A.matrixWorldInverse);let un=dt.map.cameraPosition;un!==void 0&&un.setValue(G,rn.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(G,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&dt.setValue(G,"isOrthographic",A.isOrthographicCamera===!0),Z!==A&&(Z=A,$i=!0,ms=!0)}if(ze.needsLights&&(cn.state.sunShadowMap.length>0&&dt.setValue(G,"sunShadowMap",cn.state.sunShadowMap,Ze),cn.state.directionalShadowMap.length>0&&dt.setValue(G,"directionalShadowMap",cn.state.directionalShadowMap,Ze),cn.state.spotShadowMap.length>0&&dt.setValue(G,"spotShadowMap",cn.state.spotShadowMap,Ze),cn.state.pointShadowMap.length>0&&dt.setValue(G,"pointShadowMap",cn.state.pointShadowMap,Ze)),K.isSkinnedMesh){dt.setOptional(G,K,"bindMatrix"),dt.setOptional(G,K,"bindMatrixInverse");let Ft=K.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),dt.setValue(G,"boneTexture",Ft.boneTexture,Ze))}K.isBatchedMesh&&(dt.setOptional(G,K,"batchingTexture"),dt.setValue(G,"batchingTexture",K._matricesTexture,Ze),dt.setOptional(G,K,"batchingIdTexture"),dt.setValue(G,"batchingIdTexture",K._indirectTexture,Ze),dt.setOptional(G,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(G,"batchingColorTexture",K._colorsTexture,Ze));let Hn=ne.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&le.update(K,ne,hn),($i||ze.receiveShadow!==K.receiveShadow)&&(ze.receiveShadow=K.receiveShadow,dt.setValue(G,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&W.environment!==null&&(tn.envMapIntensity.value=W.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=FE()),$i){if(dt.setValue(G,"toneMappingExposure",P.toneMappingExposure),ze.needsLights&&Hr(tn,ms),Ae&&J.fog===!0&&ve.refreshFogUniforms(tn,Ae),ve.refreshMaterialUniforms(tn,J,de,ae,b.state.transmissionRenderTarget[A.id]),ze.needsLights&&ze.numLightProbeGrids>0){let Ft=y,un=0;for(let Fn of b.state.lightProbeGridArray)Fn.texture!==null&&(Ft.textures[un]=Fn.texture,Ft.min[un]=Fn.boundingBox.min,Ft.max[un]=Fn.boundingBox.max,Ft.resolution[un]=Fn.resolution,un++);for(let Fn in Ft)Ft[Fn].length=un;tn.probesSH.value=Ft.textures,tn.probesMin.value=Ft.min,tn.probesMax.value=Ft.max,tn.probesResolution.value=Ft.resolution}qo.upload(G,Ds(ze),tn,Ze)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(qo.upload(G,Ds(ze),tn,Ze),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&dt.setValue(G,"center",K.center),dt.setValue(G,"modelViewMatrix",K.modelViewMatrix),dt.setValue(G,"normalMatrix",K.normalMatrix),dt.setValue(G,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Ft=J.uniformsGroups;for(let un=0,Fn=Ft.length;un<Fn;un++){let gl=Ft[un];Xe.update(gl,hn),Xe.bind(gl,hn)}}return hn}function Hr(A,W){A.ambientLightColor.needsUpdate=W,A.lightProbe.needsUpdate=W,A.sunLights.needsUpdate=W,A.sunLightShadows.needsUpdate=W,A.directionalLights.needsUpdate=W,A.directionalLightShadows.needsUpdate=W,A.pointLights.needsUpdate=W,A.pointLightShadows.needsUpdate=W,A.spotLights.needsUpdate=W,A.spotLightShadows.needsUpdate=W,A.rectAreaLights.needsUpdate=W,A.hemisphereLights.needsUpdate=W}function Ns(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return k},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return $},this.setRenderTargetTextures=function(A,W,ne){let J=We.get(A);J.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),We.get(A.texture).__webglTexture=W,We.get(A.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:ne,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,W){let ne=We.get(A);ne.__webglFramebuffer=W,ne.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(A,W=0,ne=0){$=A,k=W,z=ne;let J=null,K=!1,Ae=!1;if(A){let Re=We.get(A);if(Re.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(G.FRAMEBUFFER,Re.__webglFramebuffer),te.copy(A.viewport),oe.copy(A.scissor),ce=A.scissorTest,Ee.viewport(te),Ee.scissor(oe),Ee.setScissorTest(ce),X=-1;return}else if(Re.__webglFramebuffer===void 0)Ze.setupRenderTarget(A);else if(Re.__hasExternalTextures)Ze.rebindTextures(A,We.get(A.texture).__webglTexture,We.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let nt=A.depthTexture;if(Re.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(A.width!==nt.image.width||A.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(A)}}let De=A.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let He=We.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(He[W])?J=He[W][ne]:J=He[W],K=!0):A.samples>0&&Ze.useMultisampledRTT(A)===!1?J=We.get(A).__webglMultisampledFramebuffer:Array.isArray(He)?J=He[ne]:J=He,te.copy(A.viewport),oe.copy(A.scissor),ce=A.scissorTest}else te.copy(Be).multiplyScalar(de).floor(),oe.copy(st).multiplyScalar(de).floor(),ce=at;if(ne!==0&&(J=O),Ee.bindFramebuffer(G.FRAMEBUFFER,J)&&Ee.drawBuffers(A,J),Ee.viewport(te),Ee.scissor(oe),Ee.setScissorTest(ce),K){let Re=We.get(A.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+W,Re.__webglTexture,ne)}else if(Ae){let Re=W;for(let De=0;De<A.textures.length;De++){let He=We.get(A.textures[De]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+De,He.__webglTexture,ne,Re)}}else if(A!==null&&ne!==0){let Re=We.get(A.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,Re.__webglTexture,ne)}X=-1};function Wr(A){let W=We.get(A);return(W.__readFormat!==A.format||W.__readType!==A.type)&&(W.__readFormat=A.format,W.__readType=A.type,W.__formatReadable=lt.textureFormatReadable(A.format),W.__typeReadable=lt.textureTypeReadable(A.type)),W}this.readRenderTargetPixels=function(A,W,ne,J,K,Ae,Le,Re=0){if(!(A&&A.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(G.FRAMEBUFFER,De);try{let He=A.textures[Re],nt=He.format,gt=He.type;A.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Re);let Ge=Wr(He);if(Ge.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=A.width-J&&ne>=0&&ne<=A.height-K&&G.readPixels(W,ne,J,K,ye.convert(nt),ye.convert(gt),Ae)}finally{let He=$!==null?We.get($).__webglFramebuffer:null;Ee.bindFramebuffer(G.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(A,W,ne,J,K,Ae,Le,Re=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(W>=0&&W<=A.width-J&&ne>=0&&ne<=A.height-K){Ee.bindFramebuffer(G.FRAMEBUFFER,De);let He=A.textures[Re],nt=He.format,gt=He.type;A.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Re);let Ge=Wr(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,_t),G.bufferData(G.PIXEL_PACK_BUFFER,Ae.byteLength,G.STREAM_READ),G.readPixels(W,ne,J,K,ye.convert(nt),ye.convert(gt),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let Kt=$!==null?We.get($).__webglFramebuffer:null;Ee.bindFramebuffer(G.FRAMEBUFFER,Kt);let Nt=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await H0(G,Nt,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,_t),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,Ae),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(_t),G.deleteSync(Nt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,W=null,ne=0){let J=Math.pow(2,-ne),K=Math.floor(A.image.width*J),Ae=Math.floor(A.image.height*J),Le=W!==null?W.x:0,Re=W!==null?W.y:0;Ze.setTexture2D(A,0),G.copyTexSubImage2D(G.TEXTURE_2D,ne,0,0,Le,Re,K,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(A,W,ne=null,J=null,K=0,Ae=0){let Le,Re,De,He,nt,gt,Ge,_t,Kt,Nt=A.isCompressedTexture?A.mipmaps[Ae]:A.image;if(ne!==null)Le=ne.max.x-ne.min.x,Re=ne.max.y-ne.min.y,De=ne.isBox3?ne.max.z-ne.min.z:1,He=ne.min.x,nt=ne.min.y,gt=ne.isBox3?ne.min.z:0;else{let dt=Math.pow(2,-K);Le=Math.floor(Nt.width*dt),Re=Math.floor(Nt.height*dt),A.isDataArrayTexture?De=Nt.depth:A.isData3DTexture?De=Math.floor(Nt.depth*dt):De=1,He=0,nt=0,gt=0}J!==null?(Ge=J.x,_t=J.y,Kt=J.z):(Ge=0,_t=0,Kt=0);let Ut=ye.convert(W.format),yn=ye.convert(W.type),ze;W.isData3DTexture?(Ze.setTexture3D(W,0),ze=G.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Ze.setTexture2DArray(W,0),ze=G.TEXTURE_2D_ARRAY):(Ze.setTexture2D(W,0),ze=G.TEXTURE_2D),Ee.activeTexture(G.TEXTURE0),Ee.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,W.flipY),Ee.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),Ee.pixelStorei(G.UNPACK_ALIGNMENT,W.unpackAlignment);let cn=Ee.getParameter(G.UNPACK_ROW_LENGTH),yt=Ee.getParameter(G.UNPACK_IMAGE_HEIGHT),ps=Ee.getParameter(G.UNPACK_SKIP_PIXELS),hn=Ee.getParameter(G.UNPACK_SKIP_ROWS),Xr=Ee.getParameter(G.UNPACK_SKIP_IMAGES);Ee.pixelStorei(G.UNPACK_ROW_LENGTH,Nt.width),Ee.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Nt.height),Ee.pixelStorei(G.UNPACK_SKIP_PIXELS,He),Ee.pixelStorei(G.UNPACK_SKIP_ROWS,nt),Ee.pixelStorei(G.UNPACK_SKIP_IMAGES,gt);let $i=A.isDataArrayTexture||A.isData3DTexture,ms=W.isDataArrayTexture||W.isData3DTexture;if(A.isDepthTexture){let dt=We.get(A),tn=We.get(W),Hn=We.get(dt.__renderTarget),Ft=We.get(tn.__renderTarget);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let un=0;un<De;un++)$i&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,We.get(A).__webglTexture,K,gt+un),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,We.get(W).__webglTexture,Ae,Kt+un)),G.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,_t,Ge+Le,_t+Re,G.DEPTH_BUFFER_BIT,G.NEAREST);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||We.has(A)){let dt=We.get(A),tn=We.get(W);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,R),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,U);for(let Hn=0;Hn<De;Hn++)$i?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,dt.__webglTexture,K,gt+Hn):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,dt.__webglTexture,K),ms?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,tn.__webglTexture,Ae,Kt+Hn):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,tn.__webglTexture,Ae),K!==0?G.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,_t,Ge+Le,_t+Re,G.COLOR_BUFFER_BIT,G.NEAREST):ms?G.copyTexSubImage3D(ze,Ae,Ge,_t,Kt+Hn,He,nt,Le,Re):G.copyTexSubImage2D(ze,Ae,Ge,_t,He,nt,Le,Re);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else ms?A.isDataTexture||A.isData3DTexture?G.texSubImage3D(ze,Ae,Ge,_t,Kt,Le,Re,De,Ut,yn,Nt.data):W.isCompressedArrayTexture?G.compressedTexSubImage3D(ze,Ae,Ge,_t,Kt,Le,Re,De,Ut,Nt.data):G.texSubImage3D(ze,Ae,Ge,_t,Kt,Le,Re,De,Ut,yn,Nt):A.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,Ae,Ge,_t,Le,Re,Ut,yn,Nt.data):A.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,Ae,Ge,_t,Nt.width,Nt.height,Ut,Nt.data):G.texSubImage2D(G.TEXTURE_2D,Ae,Ge,_t,Le,Re,Ut,yn,Nt);Ee.pixelStorei(G.UNPACK_ROW_LENGTH,cn),Ee.pixelStorei(G.UNPACK_IMAGE_HEIGHT,yt),Ee.pixelStorei(G.UNPACK_SKIP_PIXELS,ps),Ee.pixelStorei(G.UNPACK_SKIP_ROWS,hn),Ee.pixelStorei(G.UNPACK_SKIP_IMAGES,Xr),Ae===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&G.generateMipmap(ze),Ee.unbindTexture()},this.initRenderTarget=function(A){We.get(A).__webglFramebuffer===void 0&&Ze.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ze.setTextureCube(A,0):A.isData3DTexture?Ze.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ze.setTexture2DArray(A,0):Ze.setTexture2D(A,0),Ee.unbindTexture()},this.resetState=function(){k=0,z=0,$=null,Ee.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ei}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var T_=new xi,$h=new q,$o=class extends Za{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Ht(e,3)),this.setAttribute("uv",new Ht(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new tr(t,6,1);return this.setAttribute("instanceStart",new Vi(i,3,0)),this.setAttribute("instanceEnd",new Vi(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new tr(t,6,1);return this.setAttribute("instanceColorStart",new Vi(i,3,0)),this.setAttribute("instanceColorEnd",new Vi(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Va(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xi);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),T_.setFromBufferAttribute(t),this.boundingBox.union(T_))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ki),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)$h.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared($h)),$h.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared($h));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Ie.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ke},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ni.line={uniforms:ll.merge([Ie.common,Ie.fog,Ie.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var ar=class extends Ti{constructor(e){super({type:"LineMaterial",uniforms:ll.clone(ni.line.uniforms),vertexShader:ni.line.vertexShader,fragmentShader:ni.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Bf=new Dt,A_=new q,R_=new q,Dn=new Dt,Nn=new Dt,ls=new Dt,zf=new q,kf=new Ot,Un=new ja,C_=new q,Zh=new xi,jh=new ki,cs=new Dt,hs,Br;function P_(n,e,t){return cs.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),cs.multiplyScalar(1/cs.w),cs.x=Br/t.width,cs.y=Br/t.height,cs.applyMatrix4(n.projectionMatrixInverse),cs.multiplyScalar(1/cs.w),Math.abs(Math.max(cs.x,cs.y))}function OE(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Un.start.fromBufferAttribute(s,a),Un.end.fromBufferAttribute(r,a),Un.applyMatrix4(t);let c=new q,h=new q;hs.distanceSqToSegment(Un.start,Un.end,h,c),h.distanceTo(c)<Br*.5&&e.push({point:h,pointOnLine:c,distance:hs.origin.distanceTo(h),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function BE(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),d=-e.near;hs.at(1,ls),ls.w=1,ls.applyMatrix4(e.matrixWorldInverse),ls.applyMatrix4(i),ls.multiplyScalar(1/ls.w),ls.x*=r.x/2,ls.y*=r.y/2,ls.z=0,zf.copy(ls),kf.multiplyMatrices(e.matrixWorldInverse,o);for(let u=0,m=h;u<m;u++){if(Dn.fromBufferAttribute(l,u),Nn.fromBufferAttribute(c,u),Dn.w=1,Nn.w=1,Dn.applyMatrix4(kf),Nn.applyMatrix4(kf),Dn.z>d&&Nn.z>d)continue;if(Dn.z>d){let C=Dn.z-Nn.z,y=(Dn.z-d)/C;Dn.lerp(Nn,y)}else if(Nn.z>d){let C=Nn.z-Dn.z,y=(Nn.z-d)/C;Nn.lerp(Dn,y)}Dn.applyMatrix4(i),Nn.applyMatrix4(i),Dn.multiplyScalar(1/Dn.w),Nn.multiplyScalar(1/Nn.w),Dn.x*=r.x/2,Dn.y*=r.y/2,Nn.x*=r.x/2,Nn.y*=r.y/2,Un.start.copy(Dn),Un.start.z=0,Un.end.copy(Nn),Un.end.z=0;let x=Un.closestPointToPointParameter(zf,!0);Un.at(x,C_);let f=al.lerp(Dn.z,Nn.z,x),p=f>=-1&&f<=1,M=zf.distanceTo(C_)<Br*.5;if(p&&M){Un.start.fromBufferAttribute(l,u),Un.end.fromBufferAttribute(c,u),Un.start.applyMatrix4(o),Un.end.applyMatrix4(o);let C=new q,y=new q;hs.distanceSqToSegment(Un.start,Un.end,y,C),t.push({point:y,pointOnLine:C,distance:hs.origin.distanceTo(y),object:n,face:null,faceIndex:u,uv:null,uv1:null})}}}var Jh=class extends kn{constructor(e=new $o,t=new ar({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)A_.fromBufferAttribute(t,o),R_.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+A_.distanceTo(R_);let r=new tr(s,2,1);return e.setAttribute("instanceDistanceStart",new Vi(r,1,0)),e.setAttribute("instanceDistanceEnd",new Vi(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;hs=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Br=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),jh.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=Br*.5;else{let d=Math.max(s.near,jh.distanceToPoint(hs.origin));c=P_(s,d,l.resolution)}if(jh.radius+=c,hs.intersectsSphere(jh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Zh.copy(a.boundingBox).applyMatrix4(o);let h;if(i)h=Br*.5;else{let d=Math.max(s.near,Zh.distanceToPoint(hs.origin));h=P_(s,d,l.resolution)}Zh.expandByScalar(h),hs.intersectsBox(Zh)!==!1&&(i?OE(this,t):BE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Bf),this.material.uniforms.resolution.value.set(Bf.z,Bf.w))}};var zr=class extends $o{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setPositions(i),this}setColors(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setColors(i),this}setFromPoints(e){let t=e.length-1,i=new Float32Array(6*t);for(let s=0;s<t;s++)i[6*s]=e[s].x,i[6*s+1]=e[s].y,i[6*s+2]=e[s].z||0,i[6*s+3]=e[s+1].x,i[6*s+4]=e[s+1].y,i[6*s+5]=e[s+1].z||0;return super.setPositions(i),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var Kh=class extends Jh{constructor(e=new zr,t=new ar({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};var zE=new q(0,1,0),kE=new Bo(1,1,1,40),VE=new ka(1,32,20),GE=new Js(1,1,1),HE=new za(1,1,24);function us(n){return new zo({color:n,roughness:.55,metalness:.08})}function Qh(n,e,t=!0){let i=new kn(n,e);return i.castShadow=t,i.receiveShadow=t,i}var Ls=(n,e)=>Qh(kE,n,e),kr=n=>Qh(VE,n),eu=n=>Qh(GE,n),I_=n=>Qh(HE,n,!1);function lr(n,e,t,i){let s=Pt(t,e),r=Gt(s);n.visible=r>1e-9,n.visible&&(n.position.set(...Oe(e,be(s,.5))),n.quaternion.setFromUnitVectors(zE,new q(...be(s,1/r))),n.scale.set(i,r,i))}function fl(n,e,t,i,s){let r=be(t,i/2);lr(n,Pt(e,r),Oe(e,r),s)}function tu(n,e,t,[i,s,r]){n.position.set(...e);let o=[...t.x,0,...t.y,0,...t.z,0,0,0,0,1];n.quaternion.setFromRotationMatrix(new Ot().fromArray(o)),n.scale.set(i,s,r)}function Zo(n,e,t=!1){let i=new Kh(new zr,new ar({color:n,linewidth:e}));return i.frustumCulled=!1,t&&(i.material.depthTest=!1,i.material.transparent=!0,i.renderOrder=2),i}function nu(n,e){n.visible=e.length>1,n.visible&&(n.geometry.dispose(),n.geometry=new zr,n.geometry.setPositions(e.flat()))}function L_(){let n=document.createElement("canvas");[n.width,n.height]=[8,4];let e=n.getContext("2d");for(let i=0;i<4;i++)for(let s=0;s<2;s++)e.fillStyle=(i+s)%2===0?"#111418":"#ffffff",e.fillRect(2*i,2*s,2,2);let t=new Fa(n);return t.colorSpace=Zn,t.magFilter=_n,new zo({map:t,roughness:.6})}function D_(n,e){let{x:t,y:i,z:s,half:r}=wl(e);return{x:zs(n,t),y:zs(n,i),z:zs(n,s),o:_r(n,e.com),half:r}}function N_(){let n=us("#5c6673");Object.assign(n,{transparent:!0,opacity:.5,depthWrite:!1});let e=eu(n);return{mesh:e,put(t,i){let{half:s,...r}=D_(t,i),o=Math.max(...s);tu(e,r.o,r,s.map(a=>2*Math.max(a,.02*o))),e.visible=o>0}}}function U_(n,e){let{x:t,y:i,z:s,o:r,half:o}=D_(n,e),a=[t,i,s].map((l,c)=>be(l,o[c]));return[-1,1].flatMap(l=>[-1,1].flatMap(c=>[-1,1].map(h=>Oe(r,Oe(Oe(be(a[0],l),be(a[1],c)),be(a[2],h))))))}var WE=["#e03131","#2f9e44","#1c7ed6"];function XE(){let n=new Jn,e=WE.map(i=>{let s=us(i),[r,o]=[Ls(s,!1),I_(s)];return n.add(r,o),{rod:r,head:o}});return{group:n,put:(i,s)=>{[i.x,i.y,i.z].forEach((r,o)=>{let[a,l]=[.78,1].map(c=>Oe(i.o,be(r,c*s)));lr(e[o].rod,i.o,a,.032*s),lr(e[o].head,a,l,.085*s)})}}}function cr(n){let e=n.rows.map((t,i)=>({row:t,index:i}));return n.isMounted?e.filter(({row:t})=>t.mount!==null):e}function F_(n,e,t){let i=cr(e),s=.034*t/Math.sqrt(Math.max(1,i.length/6)),r=_=>s*(1-.45*_/Math.max(i.length,4)),o=us("#c9d1db"),a=us("#5c6673"),l=new Jn;n.scene.add(l);let c=(_,v=l)=>(v.add(_),_),h=e.floating?null:{disc:c(Ls(a)),post:c(Ls(a))},d=e.floating&&N_();d&&c(d.mesh);let u=i.map(({row:_})=>{let v=us("#888888");return{color:v,body:_.isPlace?null:c(_.type==="prismatic"?eu(v):Ls(v)),caps:_.isPlace||_.type==="prismatic"?[]:[0,1].map(()=>c(Ls(a))),rods:[0,1].map(()=>c(Ls(o))),corners:[0,1].map(()=>c(kr(o)))}}),m=e.tips.map(()=>({rod:c(Ls(o)),ball:c(kr(a)),stub:c(Ls(o))})),g=c(new Jn),x=[...i,"base","world",...e.tips].map(()=>{let _=XE();return g.add(_.group),_}),f=c(new Jn),p=i.map(({row:_})=>{let v=Zo("#888888",1.6);return v.material.dashed=!0,f.add(v),v.visible=!_.isPlace,v}),M=c(new Jn),C=L_(),y=[...e.rows,...e.tips,...e.floating?[e.floating]:[]].map(()=>c(kr(C),M)),T=c(kr(us("#f08c00")),M);function b(_,v,D){let{row:P,index:I}=i[v],{middle:L,frame:O,link:R,origin:U,axis:k,before:z}=_.rows[I],{body:$,caps:X,rods:Z,corners:te}=u[v],oe=r(v),ce=e.isMounted?R.o:L.o,Q=e.isMounted?R.o:O.o;if(lr(Z[0],D,ce,.52*oe),lr(Z[1],ce,Q,.52*oe),[ce,Q].forEach((me,_e)=>{te[_e].position.set(...me),te[_e].scale.setScalar(.52*oe)}),!$)return Q;if(P.type==="prismatic"){let me=e.convention==="standard"?z:L;tu($,e.isMounted?D:U,{...me,z:k},[1.7*oe,1.7*oe,3.4*oe])}else{let me=e.isMounted?R.o:e.convention==="standard"?U:O.o;fl($,me,k,2.5*oe,oe),X.forEach((_e,ae)=>{fl(_e,Oe(me,be(k,(ae===0?1.3:-1.3)*oe)),k,.12*oe,.5*oe)})}return Q}return{paint(_){u.forEach(({color:v},D)=>{v.color.set(_(i[D].row)),p[D].material.color.set(_(i[D].row))}),n.ask()},show({frames:_,axes:v,masses:D}){g.visible=_,f.visible=v,M.visible=D,o.transparent=D,o.opacity=D?.45:1,n.ask()},put(_,v){let D=r(0),P=_.base.o;d?.put(_.base,v.floating),h&&fl(h.disc,Pt(P,be(_.base.z,1.75*D)),_.base.z,.9*D,1.9*D),h&&fl(h.post,Pt(P,be(_.base.z,1.1*D)),_.base.z,.6*D,1.25*D);let I=new Map([[null,P]]);i.forEach(({row:$,index:X},Z)=>I.set(X,b(_,Z,I.get($.on)??P)));let L=r(i.length);m.forEach(($,X)=>{let{on:Z}=v.tips[X],[te,oe]=[I.get(Z)??P,_.tips[X].o];lr($.rod,te,oe,.45*L),$.ball.position.set(...oe),$.ball.scale.setScalar(.62*L);let ce=Z===null?_.base:_.rows[Z].link,Q=Z!==null&&v.convention==="modified"&&Qi(te,oe)<.01*t;lr($.stub,ce.o,Q?_r(ce,v.rows[Z].com):ce.o,.45*L)});let O=.13*t;i.forEach(({index:$},X)=>x[X].put(_.rows[$].link,O)),x[i.length].put(_.base,1.15*O),x[i.length+1].put({x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]},1.5*O),_.tips.forEach(($,X)=>x[i.length+2+X].put($,O)),i.forEach(({row:$,index:X},Z)=>{if($.isPlace)return;let{origin:te,axis:oe,link:ce}=_.rows[X],Q=e.isMounted?ce.o:te;nu(p[Z],[-.16,.16].map(me=>Oe(Q,be(oe,me*t))))});let[R,U]=[0,[0,0,0]],k=v.rows.map(($,X)=>({...$,frame:_.rows[X].link}));v.tips.forEach(({on:$,body:X},Z)=>k.push({...$===null&&!v.floating?null:X,frame:_.tips[Z]})),v.floating&&k.push({...v.floating,frame:_.base}),y.forEach(($,X)=>{let Z=k[X];if($.visible=Z.mass>0,!$.visible)return;let te=_r(Z.frame,Z.com);$.position.set(...te),R+=Z.mass,U=Oe(U,be(te,Z.mass))});let z=Math.max(...k.map($=>$.mass??0));y.forEach(($,X)=>{$.visible&&$.scale.setScalar(.034*t*Math.cbrt(k[X].mass/z))}),T.visible=R>0,R>0&&T.position.set(...be(U,1/R)),T.scale.setScalar(.02*t),n.ask()}}}function Vf(n,e,t){let i=[e.base.o,...e.tips.map(r=>r.o)];for(let{index:r}of cr(n)){let{middle:o,link:a}=e.rows[r];i.push(a.o),n.isMounted||i.push(o.o)}n.floating&&i.push(...U_(e.base,n.floating));for(let{on:r}of n.tips)r!==null&&i.push(_r(e.rows[r].link,n.rows[r].com));let s=.05*t;return i.flatMap(r=>[r,...[0,1,2].flatMap(o=>[-s,s].map(a=>r.map((l,c)=>c===o?l+a:l)))])}var hr={theta:"#e64980",d:"#228be6",a:"#37b24d",alpha:"#f76707"},qE={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},B_="#868e96";function O_(n,e,t,i,s){let r=Math.max(2,Math.ceil(Math.abs(i)/.06)),o=be(On(Pt(t,be(e,hi(e,t)))),s);return Array.from({length:r+1},(a,l)=>Oe(n,gr(o,e,i*l/r)))}function YE(n,e){let t=n[n.length-1],i=On(Pt(t,n[n.length-2])),s=On(pn(i,Math.abs(i[2])<.9?[0,0,1]:[1,0,0]));return[1,-1].map(r=>Oe(t,Oe(be(i,-e),be(s,.4*r*e))))}function $E(n,e,t,i,s){let r=n.rows[t],{before:o,middle:a,frame:l,theta:c,d:h}=e.rows[t],d=n.convention==="standard",u=.115*s,m=t+1,g={paths:[],texts:[]},x=L=>!d&&(L==="a"||L==="alpha")?m-1:m,f=(L,O,R)=>g.texts.push({at:O,name:L,sign:qE[L],index:x(L),text:R}),p=(L,O,R,U)=>{g.paths.push({color:hr[L],path:O,width:3.2});let[k,z]=YE(O,.03*s),$=O[O.length-1];g.paths.push({color:hr[L],path:[k,$,z],width:3.2}),f(L,R,U)},M=(L,O)=>g.paths.push({color:B_,path:[L,O],width:1.4}),C=L=>L[Math.floor(L.length/2)],[y,T]=d?[o,a]:[a,l],[b,_]=d?[a,l]:[o,a],v=d?y.o:T.o,D=d?_.o:b.o,P=L=>Math.abs(L)<1e-9,I=y.z;for(let L of[y.x,T.x])M(v,Oe(v,be(L,1.25*u)));if(P(c))f("theta",Oe(v,be(T.x,1.3*u)),i.angle(0));else{let L=O_(v,I,y.x,c,u),O=On(Pt(C(L),v));p("theta",L,Oe(v,be(O,1.2*u)),i.angle(c))}if(Math.abs(h)>1e-9&&p("d",[y.o,T.o],be(Oe(y.o,T.o),.5),i.length(h)),Math.abs(r.a)>1e-9&&p("a",[b.o,_.o],be(Oe(b.o,_.o),.5),i.length(r.a)),!P(r.alpha)){for(let R of[b.z,_.z])M(D,Oe(D,be(R,1.25*u)));let L=O_(D,b.x,b.z,r.alpha,u),O=On(Pt(C(L),D));p("alpha",L,Oe(D,be(O,1.2*u)),i.angle(r.alpha))}return g}function ZE(n,e,t,i,s,r){let{link:o,axis:a}=e.rows[t],l={paths:[],texts:[]},c=[i.o,o.o];if(Qi(...c)>1e-9){l.paths.push({color:hr.a,path:c,width:3.2});let d=Pt(o.o,i.o),u=[i.x,i.y,i.z].map(m=>s.number(hi(m,d)));l.texts.push({at:be(Oe(...c),.5),name:"a",sign:"xyz",index:null,text:`${u.join(", ")} m`})}let h=Oe(o.o,be(a,.2*r));return l.paths.push({color:hr.theta,path:[o.o,h],width:3.2}),l.texts.push({at:h,name:"theta",sign:"axis",index:null,text:""}),l}function z_(n,e,t){let i=new Jn;n.scene.add(i);let s=[],r=cr(e);return{put(o,a,l,c){let h=l.map(u=>{if(!e.isMounted)return $E(a,o,u,c,t);let m=r.findIndex(x=>x.index===u),g=m>0?o.rows[r[m-1].index].link:o.base;return ZE(a,o,u,g,c,t)}),d=h.flatMap(({paths:u})=>u);for(;s.length<d.length;){let u=Zo(B_,1,!0);i.add(u),s.push(u)}return s.forEach((u,m)=>{u.visible=m<d.length,u.visible&&(nu(u,d[m].path),u.material.color.set(d[m].color),u.material.linewidth=d[m].width)}),n.ask(),h.flatMap(({texts:u})=>u)}}}var jE=24;function k_(n,e,t){let{state:i,size:s}=n,r=kr(us("#f08c00"));r.scale.setScalar(s/45),e.scene.add(r);function o(){r.visible=i.mode==="reach",r.visible&&r.position.set(...i.target.slice(0,3)),e.ask()}let a=({clientX:d,clientY:u})=>{let{left:m,top:g}=e.canvas.getBoundingClientRect();return[d-m,u-g]},[l,c]=[null,null];t.addEventListener("pointerdown",d=>{if(i.mode!=="reach"||d.target!==e.canvas)return;let u=e.onCanvas(i.target.slice(0,3));!u||Qi([...u,0],[...a(d),0])>jE||(l=d.pointerId,e.hold(!0),e.canvas.setPointerCapture(l))},!0),t.addEventListener("pointermove",d=>{if(d.pointerId!==l)return;let u=c!==null;c=a(d),u||requestAnimationFrame(h)});function h(){c!==null&&(e.under(c,i.target.slice(0,3)).forEach((d,u)=>i.target[u]=d),c=null,n.seek(!0))}for(let d of["pointerup","pointercancel"])t.addEventListener(d,u=>{u.pointerId===l&&(h(),l=null,e.hold(!1),n.seek())});e.onDraw(()=>{r.visible&&(t.dataset.handle=e.onCanvas(i.target.slice(0,3))?.map(Math.round).join(" "))}),n.on("reached mode",o),o()}var pl=2;function V_(n,e){let t=[],i=[];function s(){let r=[],{clientWidth:o,clientHeight:a}=e;t.forEach(({at:l},c)=>{let h=i[c],d=n.onCanvas(l);if(h.hidden=d===null,!d)return;let[u,m]=[h.offsetWidth,h.offsetHeight],g=Math.min(Math.max(d[0]-u/2,2),o-u-2),x=Math.min(Math.max(d[1]-m/2,2),a-m-2);for(let f=0;f<12;f++){let p=r.find(M=>!(g>M.x+M.wide+pl||M.x>g+u+pl)&&x<M.y+M.high+pl&&M.y<x+m+pl);if(!p)break;x=p.y+p.high+pl+.5}r.push({x:g,y:x,wide:u,high:m}),h.style.transform=`translate(${g}px, ${x}px)`})}return n.onDraw(s),{put(r){for(t=r;i.length<r.length;)i.push(e.appendChild(H("span")));i.forEach((o,a)=>{if(o.hidden=a>=r.length,o.hidden)return;let{content:l,kind:c,color:h}=r[a];o.className=`label ${c}`,o.style.setProperty("--color",h),o.replaceChildren(...[l].flat())}),n.ask()}}}var G_={type:"change"},Hf={type:"start"},W_={type:"end"},iu=new Ir,H_=new gi,JE=Math.cos(70*al.DEG2RAD),wn=new q,ri=2*Math.PI,Rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Gf=1e-6,su=class extends Ka{constructor(e,t=null){super(e,t),this.state=Rt.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:nr.ROTATE,MIDDLE:nr.DOLLY,RIGHT:nr.PAN},this.touches={ONE:ir.ROTATE,TWO:ir.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new Qn,this._lastTargetPosition=new q,this._quat=new Qn().setFromUnitVectors(e.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Vo,this._sphericalDelta=new Vo,this._scale=1,this._panOffset=new q,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new q,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=QE.bind(this),this._onPointerDown=KE.bind(this),this._onPointerUp=eT.bind(this),this._onContextMenu=aT.bind(this),this._onMouseWheel=iT.bind(this),this._onKeyDown=sT.bind(this),this._onTouchStart=rT.bind(this),this._onTouchMove=oT.bind(this),this._onMouseDown=tT.bind(this),this._onMouseMove=nT.bind(this),this._interceptControlDown=lT.bind(this),this._interceptControlUp=cT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Rt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(G_),this.update(),this.state=Rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;wn.copy(t).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===Rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ri:i>Math.PI&&(i-=ri),s<-Math.PI?s+=ri:s>Math.PI&&(s-=ri),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),t.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(iu.origin.copy(this.object.position),iu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(iu.direction))<JE?this.object.lookAt(this.target):(H_.setFromNormalAndCoplanarPoint(this.object.up,this.target),iu.intersectPlane(H_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Gf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Gf||this._lastTargetPosition.distanceToSquared(this.target)>Gf?(this.dispatchEvent(G_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ri/60*this.autoRotateSpeed*e:ri/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){wn.setFromMatrixColumn(t,0),wn.multiplyScalar(-e),this._panOffset.add(wn)}_panUp(e,t){this.screenSpacePanning===!0?wn.setFromMatrixColumn(t,1):(wn.setFromMatrixColumn(t,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(e),this._panOffset.add(wn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function KE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function QE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function eT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(W_),this.state=Rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function tT(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case nr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Rt.DOLLY;break;case nr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Rt.ROTATE}break;case nr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Rt.PAN}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(Hf)}function nT(n){switch(this.state){case Rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function iT(n){this.enabled===!1||this.enableZoom===!1||this.state!==Rt.NONE||(n.preventDefault(),this.dispatchEvent(Hf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(W_))}function sT(n){this.enabled!==!1&&this._handleKeyDown(n)}function rT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ir.ROTATE:if(this.enableRotate===!1){this.state=Rt.NONE;break}this._handleTouchStartRotate(n),this.state=Rt.TOUCH_ROTATE;break;case ir.PAN:if(this.enablePan===!1){this.state=Rt.NONE;break}this._handleTouchStartPan(n),this.state=Rt.TOUCH_PAN;break;default:this.state=Rt.NONE}break;case 2:switch(this.touches.TWO){case ir.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Rt.TOUCH_DOLLY_PAN;break;case ir.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Rt.TOUCH_DOLLY_ROTATE;break;default:this.state=Rt.NONE}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(Hf)}function oT(n){switch(this._trackPointer(n),this.state){case Rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Rt.NONE}}function aT(n){this.enabled!==!1&&n.preventDefault()}function lT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function cT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Wf(n){let e=Math.abs(n[0])<.9?[1,0,0]:[0,1,0],t=On(Pt(e,be(n,hi(e,n))));return[t,pn(n,t)]}function X_(n,e,t){let i;try{i=new Xh({canvas:n,antialias:!0,alpha:!0})}catch{return null}i.shadowMap.enabled=!0;let s=new Ia,r=new jn(32,1,t/100,t*60);r.up.set(...e);let o=new su(r,n);o.enableDamping=!1,o.minDistance=t/10,o.maxDistance=t*20;let a=new Xa(16777215,9279912,1.6);a.position.set(...e);let[l,c]=Wf(e),h=new $a(16777215,2.2),d=Oe(Oe(be(e,2.2),be(l,.9)),be(c,-1.1));h.castShadow=!0,h.shadow.mapSize.set(1024,1024),h.shadow.radius=5,h.shadow.bias=-5e-4,h.shadow.normalBias=t/200,Object.assign(h.shadow.camera,{left:-1.6*t,right:1.6*t,top:1.6*t,bottom:-1.6*t,near:.1*t,far:8*t}),s.add(a,h,h.target);let u=new Qn().setFromUnitVectors(new q(0,0,1),new q(...e)),m=new kn(new Lr(12*t,12*t),new Ga({opacity:.16}));m.quaternion.copy(u),m.receiveShadow=!0,s.add(m);let g=null,x=!1,f=[],p=()=>{x=!1,i.render(s,r),f.forEach(y=>y())},M=()=>{x||requestAnimationFrame(p),x=!0};o.addEventListener("change",M);let C=()=>{let{clientWidth:y,clientHeight:T}=n;y===0||T===0||(i.setPixelRatio(Math.min(devicePixelRatio,2)),i.setSize(y,T,!1),r.aspect=y/T,r.updateProjectionMatrix(),M())};return new ResizeObserver(C).observe(n),{scene:s,camera:r,canvas:n,ask:M,onDraw:y=>f.push(y),ground(y,T,b,_=!0){m.visible=_;let v=Oe(y,be(e,T-hi(y,e)));m.position.set(...v),h.target.position.set(...y),h.position.set(...Oe(y,be(On(d),4*t))),g&&s.remove(g);let D=10**Math.floor(Math.log10(t/2)),P=[1,2,5,10].map(L=>L*D).find(L=>L>=t/8),I=2*Math.ceil(2*t/P);return g=new Ja(I*P,I,new ht(b[0]),new ht(b[1])),g.quaternion.setFromUnitVectors(new q(0,1,0),new q(...e)),g.position.set(...Oe(v,be(e,-t/500))),s.add(g),M(),P},look(y,T){C();let _=[0,1,2].map(L=>T.map(O=>O[L])).map(L=>(Math.min(...L)+Math.max(...L))/2),v=Math.max(...T.map(L=>Gt(Pt(L,_))),t/8),D=r.fov*Math.PI/360,P=Math.min(D,Math.atan(Math.tan(D)*r.aspect)),I=1.12*v/Math.sin(P);r.position.set(...Oe(_,be(On(y),I))),o.target.set(..._),o.update(),M()},follow(y){for(let{position:T}of[r,h,h.target])T.set(...Oe(T.toArray(),y));o.target.set(...Oe(o.target.toArray(),y)),o.update(),M()},turn(y,T){let b=o.target.toArray(),_=Pt(r.position.toArray(),b),v=On(pn(e,_)),D=gr(gr(_,e,y),v,-T);Gt(pn(On(D),e))<.05||(r.position.set(...Oe(b,D)),o.update(),M())},zoom(y){let T=o.target.toArray(),b=Pt(r.position.toArray(),T);r.position.set(...Oe(T,be(b,y))),o.update(),M()},under([y,T],b){let{clientWidth:_,clientHeight:v}=n,{z:D}=new q(...b).project(r);return new q(2*y/_-1,1-2*T/v,D).unproject(r).toArray()},hold(y){o.enabled=!y},onCanvas(y){let T=new q(...y).project(r);if(T.z>1)return null;let{clientWidth:b,clientHeight:_}=n;return[(T.x+1)/2*b,(1-T.y)/2*_]}}}var hT=[.1,.25,.5,1,2],q_={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z"};function uT(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",n),e.append(t),e}function Y_(n){let{state:e}=n,t=H("button",{type:"button",class:"play","data-key":"play"}),i=H("input",{type:"range",min:0,step:"any","data-key":"time","aria-label":"Time"}),s=H("output",{class:"time","data-key":"seconds"}),r=H("select",{"aria-label":"Speed","data-key":"speed"},hT.map(u=>H("option",{value:u,selected:u===1},`${u}\xD7`))),o=H("input",{type:"checkbox","data-key":"repeat"}),a=null;function l(u){if(!e.isPlaying){a=null;return}if(a!==null){let{duration:m}=n.trajectory,g=e.t+(u-a)/1e3*e.speed;g>=m&&o.checked&&m>0&&(g%=m),g>=m&&n.play(!1),n.setTime(g)}a=u,requestAnimationFrame(l)}function c(){t.replaceChildren(uT(e.isPlaying?q_.pause:q_.play)),t.setAttribute("aria-label",e.isPlaying?"Pause":"Play"),e.isPlaying&&a===null&&requestAnimationFrame(l)}function h(){let{duration:u}=n.trajectory??{duration:0};i.max=u,i.value=e.t;let m=`${e.t.toFixed(2)} / ${u.toFixed(2)} s`;i.setAttribute("aria-valuetext",m),s.textContent=m,d.hidden=n.trajectory===null}t.addEventListener("click",()=>n.play(!e.isPlaying)),i.addEventListener("input",()=>{n.play(!1),n.setTime(Number(i.value))}),r.addEventListener("change",()=>e.speed=Number(r.value));let d=H("div",{class:"transport",role:"group","aria-label":"Time"},t,i,s,r,H("label",{class:"check"},o,"repeat"));return n.on("play",c),n.on("time trajectory",h),c(),h(),d}function dT(n){return Gt(n.gravity)>1e-9?On(be(n.gravity,-1)):[0,0,1]}function fT(n,e){if(n.floating)return null;let{rows:t}=Ii(n,new Array(n.joints).fill(0),null),i=n.rows.flatMap((o,a)=>o.type==="revolute"&&o.joint!==null?[t[a].axis]:[]);if(i.length===0)return null;let[s]=i;return i.every(o=>Gt(pn(s,o))<1e-6)&&Math.abs(hi(s,e))<1e-6?s:null}function $_(n){let{table:e,state:t,size:i}=n,s=H("canvas",{tabIndex:0,role:"img"}),r=H("div",{class:"labels","aria-hidden":"true"}),o=H("output",{class:"readout"}),a=H("span",{class:"scale"}),l=H("div",{class:"views",role:"group","aria-label":"View"}),c=H("div",{class:"shown",role:"group","aria-label":"What is shown"}),h=H("div",{class:"view"},s,r,l,o,a),d=H("section",{class:"panel stage","aria-label":"The arm"},h,c,Y_(n));s.setAttribute("aria-label",`${e.name} in 3D; drag to turn, arrow keys too, plus and minus to zoom`);function u(){let f=dT(e),p=X_(s,f,i);if(!p){h.classList.add("missing"),h.append(H("p",{},"This browser draws no WebGL: the arm is not shown. All numbers are."));return}let M=F_(p,e,i),C=z_(p,e,i),y=V_(p,r);k_(n,p,h);let T=cr(e),b=Zo("#f08c00",2.4);b.visible=!1,p.scene.add(b);let _=fT(e,f),[v,D]=Wf(f),P=_??be(D,-1),I=pn(f,P),O={"3D":_?Oe(Oe(P,be(I,.22)),be(f,.16)):Oe(Oe(be(v,.75),be(D,-.9)),be(f,.55)),front:Oe(P,be(f,1e-4)),side:Oe(I,be(f,1e-4)),top:Oe(f,be(P,.001))},R="3D";function U(ae,de,Ne){let Ye=Ii(n.table,de,ae),Be=X()?Pt(Ne,Ye.base.o):[0,0,0];return Vf(n.table,Ye,i).map(st=>Oe(st,Be))}function k(ae){R=ae;let de=n.trajectory??{q:[],base:[]},Ne=Math.max(1,Math.floor(de.q.length/12)),Ye=n.frames().base.o,Be=de.q.flatMap(($e,pt)=>pt%Ne===0||pt===de.q.length-1?U(de.base[pt],$e,Ye):[]).concat(U(n.start(),t.q,Ye)).filter($e=>Qi($e,Ye)<1.6*i);$=Ye;let st=Ii(n.table,t.q,n.start()),at=e.floating?Vf(n.table,st,i):Be;z=Math.min(...at.map($e=>hi($e,f)),hi(st.base.o,f)-.09*i),te(),p.look(O[ae],Be.length>0?Be:[Ye])}let z=0,$=[0,0,0],X=()=>e.floating!==null&&t.mode==="free"&&t.show.isFollowed;function Z(ae){X()&&p.follow(Pt(ae,$)),$=ae}function te(){let{base:ae}=Ii(n.table,t.q,n.start()),de=e.floating!==null&&t.mode==="free",Ne=p.ground(ae.o,z,[Tr("--grid-strong"),Tr("--grid")],!de);a.textContent=`grid ${Ne>=1?Ne:Number(Ne.toPrecision(3))} m`}for(let ae of Object.keys(O))l.append(H("button",{type:"button",class:"chip","data-key":`view-${ae}`,onclick:()=>k(ae)},ae));s.addEventListener("keydown",({key:ae})=>{let de={ArrowLeft:[-.1,0],ArrowRight:[.1,0],ArrowUp:[0,.1],ArrowDown:[0,-.1]};de[ae]&&p.turn(...de[ae]),(ae==="+"||ae==="-")&&p.zoom(ae==="+"?.9:1/.9)});function oe(){let{parameters:ae}=t.show;if(ae==="none")return[];let de=T.filter(({row:Ne})=>!Ne.isPlace).map(({index:Ne})=>Ne);return ae==="all"?de:de.filter(Ne=>Ne===t.selected)}function ce(){let ae=n.frames();Z(ae.base.o),M.put(ae,n.table);let de=C.put(ae,n.table,oe(),n.units),Ne=({o:pt},Mt)=>({at:pt,content:Mt,kind:"frame",color:"var(--ink)"}),Ye=t.show.frames?[Ne(ae.base,"0"),...T.map(({row:pt,index:Mt},jt)=>Ne(ae.rows[Mt].link,pt.isPlace?"tip":String(jt+1))),...(e.tips.length>1?e.tips:[]).map((pt,Mt)=>Ne(ae.tips[Mt],pt.name))]:[],Be=de.map(({at:pt,name:Mt,sign:jt,index:Ct,text:rn})=>({at:pt,content:[...fn(jt,Ct),rn?` = ${rn}`:""],kind:"parameter",color:hr[Mt]}));y.put([...Ye,...Be]);let[st,at,$e]=ae.tips[t.tip].o.map(pt=>(Math.abs(pt)<5e-7?0:pt).toFixed(4));o.textContent=`${n.tip().name}  x ${st}  y ${at}  z ${$e} m`,me()}function Q(){let{trajectory:ae}=n,de=ae?.tip??[];b.visible=de.length>1,b.visible&&(b.geometry.dispose(),b.geometry=new b.geometry.constructor,b.geometry.setPositions(de.flat()),me())}function me(){let{trajectory:ae}=n;if(!ae||ae.t.length<2){b.visible=!1;return}let de=Math.floor(t.t/ae.duration*(ae.t.length-1)+1e-9);b.visible=t.show.trace&&de>0,b.geometry.instanceCount=de,p.ask()}function _e(){let ae=de=>de.joint??de.follows?.joint;M.paint(de=>Tr(ae(de)===void 0?"--muted":`--joint-${ae(de)%8}`)),b.material.color.set(Tr("--trace")),te()}n.on("time fields units selection tip",ce),n.on("trajectory",Q),n.on("show",()=>{M.show(t.show),ce()}),n.on("theme",_e),n.on("mode",()=>k(R)),M.show(t.show),k("3D"),_e(),ce(),Q(),requestAnimationFrame(()=>k("3D"))}let m=H("select",{"data-key":"parameters"},Object.entries({selected:"selected row",all:"all rows",none:"none"}).map(([f,p])=>H("option",{value:f},p)));m.addEventListener("change",()=>n.setShown({parameters:m.value}));let g=e.isMounted?"placement":"D-H parameters";if(c.append(H("label",{class:"choice"},H("span",{},g),m)),e.tips.length>1){let f=H("select",{"data-key":"tip"},e.tips.map(({name:p},M)=>H("option",{value:M},p)));f.addEventListener("change",()=>n.setTip(Number(f.value))),c.append(H("label",{class:"choice"},H("span",{},"frame"),f))}let x={frames:"frames",axes:"axes",masses:"masses",trace:"trace"};e.floating&&(x.isFollowed="follow the fall");for(let[f,p]of Object.entries(x)){let M=H("input",{type:"checkbox",checked:t.show[f],"data-key":`show-${f}`});M.addEventListener("change",()=>n.setShown({[f]:M.checked})),c.append(H("label",{class:"check"},M,p))}return{section:d,start:u}}var pT={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},mT={standard:["theta","d","a","alpha"],modified:["alpha","a","d","theta"]},ur=(n,e=4)=>n.map(t=>mt(t,e)).join(", ");function Z_(n){let{table:e,state:t}=n,i=cr(e),s=e.isMounted?["xyz","rpy","axis"]:mT[e.convention],r=e.rows.some(v=>v.limits),o=e.rows.some(v=>v.gearRatio!==0&&v.motorInertia!==0),a=e.rows.some(v=>v.viscous||v.coulomb.some(Boolean)||v.stribeck||v.spring),l=H("input",{type:"checkbox","data-key":"bodies"}),c=H("thead"),h=H("tbody"),d=H("caption");function u(){let{angleUnit:v}=n.units,D=I=>e.convention==="modified"&&(I==="a"||I==="alpha"),P=s.map(I=>{if(e.isMounted){let U={xyz:"m",rpy:v,axis:""}[I];return H("th",{scope:"col"},I," ",H("span",{class:"unit"},U))}let L=H("span",{class:"swatch"});L.style.background=hr[I];let O=I==="a"||I==="d"?"m":v,R=fn(pT[I],D(I)?"i\u22121":"i");return H("th",{scope:"col"},L,R," ",H("span",{class:"unit"},O))});r&&P.push(H("th",{scope:"col"},"limits")),P.push(H("th",{scope:"col"},"mass ",H("span",{class:"unit"},"kg"))),l.checked&&(P.push(H("th",{scope:"col"},"centre of mass ",H("span",{class:"unit"},"m"))),P.push(H("th",{scope:"col"},"inertia xx, yy, zz, xy, yz, xz ",H("span",{class:"unit"},"kg m\xB2"))),o&&P.push(H("th",{scope:"col"},"motor")),a&&P.push(H("th",{scope:"col"},"friction, spring"))),c.replaceChildren(H("tr",{},H("th",{scope:"col"},"joint"),P))}function m(v){if(v.joint!==null)return fn("q",v.joint+1);if(!v.follows)return null;let{joint:D,factor:P,offset:I}=v.follows,L=P===1?"":P===-1?"-":`${mt(P)} `,O=I===0?"":` ${I<0?"-":"+"} ${mt(Math.abs(I))}`;return[L,...fn("q",D+1),O]}function g(v,D){let{cell:P}=n.units;if(e.isMounted){let{places:z,axis:$}=v.mount,X=pp(z),[Z,te]=$,oe=[Math.sin(te)*Math.cos(Z),Math.sin(te)*Math.sin(Z),Math.cos(te)],ce={xyz:ur(X.xyz),rpy:X.rpy.map(P).join(", "),axis:ur(oe.map(Q=>Math.abs(Q)<1e-12?0:Q))};return H("td",{},D==="axis"&&v.isPlace?"":ce[D])}let I=D==="theta"||D==="alpha",L=I?P(v[D]):mt(v[D],6),O=v.text[D],R=D===(v.type==="prismatic"?"d":"theta"),U=R?m(v):null,k=O?[H("i",{},O),H("span",{class:"unit"},` = ${L}`)]:[L];if(U)return H("td",{class:"variable"},U,v[D]===0&&!O?null:[" + ",k]);if(R&&v.locked!==null&&!v.isPlace){let z=v[D]+v.locked;return H("td",{},I?P(z):mt(z,6)," ",H("span",{class:"kind"},"locked"))}return H("td",{},k)}function x(v){let{viscous:D,coulomb:P,stribeck:I,spring:L}=v,O=P[0]===P[1];return[D?`viscous ${mt(D)}`:null,P.some(Boolean)?`Coulomb ${O?mt(P[0]):`+${mt(P[0])} / -${mt(P[1])}`}`:null,I?`static ${mt(I.friction)} below ${mt(I.velocity)}`:null,L?`spring ${mt(L.stiffness)} at ${mt(L.rest)}`:null].filter(Boolean).join(", ")}let f=({xyz:v,rpy:D})=>`xyz ${ur(v)} m, rpy ${D.map(n.units.cell).join(", ")} ${n.units.angleUnit}`,p=v=>v===null?"the base":e.rows[v].name;function M(v,D){return v.follows?e.isMounted?["follows ",m(D)]:"follows":v.locked===null?v.type:e.isMounted?`locked at ${mt(D.locked*n.units.factor(v.type))} ${n.units.position(v.type)}`:"locked"}function C({row:v,index:D}){let P=n.table.rows[D],{factor:I,position:L}=n.units,O=v.joint??v.follows?.joint,R=H("th",{scope:"row"});if(v.isPlace)R.append("tip");else{let k=H("button",{type:"button",class:"name",onclick:()=>n.select(D)});k.append(H("span",{class:"dot"}),v.name||"fixed"," "),k.append(H("span",{class:"kind"},M(v,P))),(v.on??-1)!==D-1&&k.append(H("span",{class:"kind"},` on ${p(v.on)}`));let z=e.isMounted?[]:P.step.map($=>`, at ${f($)}`);k.append(H("span",{class:"kind"},...z)),R.append(k)}R.style.setProperty("--color",O===void 0?"var(--muted)":`var(--joint-${O%8})`);let U=s.map(k=>g(P,k));if(r){let k=I(v.type),z=P.limits?.map($=>mt($*k));U.push(H("td",{},z?`${z[0]} \u2026 ${z[1]} ${L(v.type)}`:""))}if(U.push(H("td",{},P.text.mass?[H("i",{},P.text.mass),` = ${mt(P.mass)}`]:mt(P.mass))),l.checked){U.push(H("td",{},ur(P.com)),H("td",{},ur(P.inertia)));let{motorInertia:k,gearRatio:z}=P;o&&U.push(H("td",{},k?`${mt(k)} kg m\xB2 \xD7 ${mt(z)}\xB2`:"")),a&&U.push(H("td",{},x(P)))}return H("tr",{"data-row":D},R,U)}function y(v,D,P){let I=[H("td",{colSpan:s.length+(r?1:0)},f(D)),H("td",{},P)];return l.checked&&I.push(H("td",{colSpan:4},D.com?ur(D.com):"")),H("tr",{class:"placed"},H("th",{scope:"row"},v),I)}function T({mass:v,com:D,inertia:P}){let I=[H("td",{colSpan:s.length+(r?1:0)},"moves freely"),H("td",{},mt(v))];return l.checked&&I.push(H("td",{},ur(D)),H("td",{},ur(P))),H("tr",{class:"placed"},H("th",{scope:"row"},"base"),I)}function b(){let{base:v,floating:D,tool:P}=n.table;u();let I=i.map(C);v&&I.unshift(y("base",v,"")),D&&I.unshift(T(D)),P&&I.push(y("tool",P,mt(P.mass)));for(let{name:L,on:O,places:R,body:U}of n.table.tips.filter(k=>k.isFrame&&k.places.length===1))I.push(y(`${L} on ${p(O)}`,{...R[0],com:U?.com},U?mt(U.mass):""));h.replaceChildren(...I),d.textContent=e.isMounted?"Joints as the file places them":`Denavit-Hartenberg table, ${e.convention} convention`,_()}function _(){for(let v of h.children)v.classList.toggle("selected",Number(v.dataset.row)===t.selected)}return l.addEventListener("change",b),n.on("fields units",b),n.on("selection",_),b(),H("section",{class:"panel table","aria-label":"Table"},Pi("Table of the arm",H("table",{class:"cells"},d,c,h)),H("label",{class:"check"},l,"bodies, motors, friction"))}var Xf=["auto","light","dark"];function gT({floating:n,convention:e,isMounted:t,gravity:i},s){let r=s.map(({type:h})=>h==="revolute"?"R":"P").join(""),o=i.map(h=>mt(h)).join(", "),a=t?"joints of a URDF file":`${e} D-H table`,l=n?["a base that moves"]:[],c=s.length===0?[]:[`${s.length} ${s.length===1?"joint":"joints"} (${r})`,a];return[...l,...c,`gravity (${o}) m/s\xB2`].join(", ")}function _T(n){let e=H("button",{type:"button",class:"quiet","data-key":"theme"}),t=0,i=()=>{document.documentElement.dataset.theme=Xf[t],e.textContent=`Colors: ${Xf[t]}`};e.addEventListener("click",()=>{t=(t+1)%Xf.length,i(),n.tell("theme")}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n.tell("theme")),i();let s=H("button",{type:"button",class:"quiet","data-key":"units"}),r=()=>s.textContent=`Angles: ${n.units.inDegrees?"degrees":"radians"}`;return s.addEventListener("click",()=>n.setUnits(!n.units.inDegrees)),n.on("units",r),r(),H("header",{},H("div",{},H("h1",{},n.table.name),H("p",{class:"said"},gT(n.table,n.joints))),H("div",{class:"switches"},s,e))}var Vr=sm(globalThis.robotTable,globalThis.robotEquations,globalThis.robotStart),j_=$_(Vr),J_=Ig(Vr);document.getElementById("page").append(_T(Vr),H("main",{},H("div",{class:"column fixed"},j_.section,Z_(Vr)),H("div",{class:"column"},Ap(Vr),Ep(Vr),J_.section)),H("footer",{},"M, V, G, \u03C4 and the motion are computed in this page by functions that robot-dynamics has proven equal to the textbook Lagrangian. SI units."));j_.start();J_.build();globalThis.robotPage=Vr;document.documentElement.dataset.ready="true";
